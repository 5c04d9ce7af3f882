// Takes a watched match, step by step; gives the pictures that tell it: of each rack its break, its
// middle and its end.
#pragma once

#include "client/app/client_state.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace billiards::client {

/// A picture that the last shot is good for.
struct DuePicture {
    std::string name;  ///< "rack2-middle"
    std::optional<double>
        at_s;  ///< After the strike; none: the balls rest, and the ruling is told.

    friend bool operator==(const DuePicture&, const DuePicture&) = default;
};

/// Each name is given once. A rack that is won has all three, however short it was: its middle is
/// the first shot that leaves at most half of the balls, or else the one that ends it. A rack that
/// is given up has its end.
class RackPictures {
  public:
    /// One message, told as the table before it and after it; to be asked after each.
    std::vector<DuePicture> due(const TableView& before, const TableView& after);

  private:
    std::set<std::string> taken_;
};

}  // namespace billiards::client
