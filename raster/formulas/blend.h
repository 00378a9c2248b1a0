// Blends one colour over another (Porter and Duff 1984, "over"), channel by channel.

// c = c_s a + c_d (1 - a), where c_s is the source's channel, a its alpha and c_d the stored
// channel. For alpha itself the source channel is 1.
template <Number F>
inline F blended_channel(F source, F alpha, F stored) {
  return source * alpha + stored * (1.0f - alpha);
}
