// Takes contacts that close at the same instant; gives the impulses that stop all of them at once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace billiards::physics {

/// The linear complementarity problem of simultaneous contacts: impulses l >= 0 with
/// c - A l <= 0, and l_i = 0 where contact i is left parting. c = closing speeds, all above 0;
/// A = how much speed an impulse at contact j takes from contact i: symmetric, and singular where
/// contacts depend on each other, as in a rack. (Smith et al., "Reflections on simultaneous
/// impact", 2012.) No result depends on the order in which the contacts come.
class StoppingImpulses {
  public:
    /// `mobility` is A, row by row. The result is valid until the next call.
    std::span<const double> solve(std::span<const double> closing_mps,
                                  std::span<const double> mobility);

  private:
    void solve_active();
    bool revise_active();
    void scale_to_best();
    double row_times(std::size_t row, std::span<const double> vector);
    double dot(std::span<const double> a, std::span<const double> b);

    std::span<const double> closing_;
    std::span<const double> mobility_;
    std::vector<char> is_active_;
    std::vector<double> impulse_;
    std::vector<double> residual_;
    std::vector<double> direction_;
    std::vector<double> mapped_;
    std::vector<double> terms_;
};

}  // namespace billiards::physics
