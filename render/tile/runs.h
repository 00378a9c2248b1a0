// Visits the entries of a table in runs of neighbours, leaving some out.
#pragma once

#include <algorithm>
#include <cstddef>

namespace glassbox {

// Calls visit(first, count) for each longest run of entries whose groups are included, within the
// `count` entries from `first` on. Group g has entries g * size .. g * size + size - 1.
template <class IsIn, class Visit>
void for_each_run(std::size_t first, std::size_t count, std::size_t size, const IsIn& is_in,
                  const Visit& visit) {
  const std::size_t end = first + count;
  std::size_t begin = first;  // the beginning of the run that is not yet visited
  for (std::size_t at = first; at < end;) {
    const std::size_t group = at / size, next = std::min(end, (group + 1) * size);
    if (!is_in(group)) {
      if (at > begin) visit(begin, at - begin);
      begin = next;
    }
    at = next;
  }
  if (end > begin) visit(begin, end - begin);
}

}  // namespace glassbox
