#include "protocol/methods/library/entries.h"

#include "protocol/calls/method.h"

namespace selvage::protocol::methods::library {

using calls::MethodKind;

calls::Method library_add_method() {
  return calls::served_method<LibraryAddParams, LibraryAddResult>("library.add", MethodKind::kRead,
                                                                  "Stores an open marker in the library.");
}

calls::Method library_get_method() {
  return calls::served_method<LibraryIdParams, LibraryGetResult>("library.get", MethodKind::kRead,
                                                                 "Returns a stored marker.");
}

calls::Method library_list_method() {
  return calls::served_method<LibraryListParams, LibraryListResult>("library.list", MethodKind::kRead,
                                                                    "Lists the stored markers.");
}

calls::Method library_remove_method() {
  return calls::served_method<LibraryIdParams, LibraryRemoveResult>("library.remove", MethodKind::kRead,
                                                                    "Removes a stored marker from the library.");
}

calls::Method library_search_method() {
  return calls::served_method<LibrarySearchParams, LibrarySearchResult>(
      "library.search", MethodKind::kRead, "Finds the stored markers that are most similar to an open marker.");
}

}  // namespace selvage::protocol::methods::library
