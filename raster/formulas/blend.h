// One colour over another (Porter and Duff 1984, "over"), channel by channel.

// c = c_s a + c_d (1 - a). Of alpha itself: a channel that is 1 in the source.
template <Number F>
inline F laid_over(F source, F alpha, F stored) {
  return source * alpha + stored * (1.0f - alpha);
}
