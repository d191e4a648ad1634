/// At which resolution a view is drawn: whole when it rests, 1/2 or 1/4 while it changes and would be slow. Pure.
#pragma once

namespace lumenshop {

class Resolution {
 public:
  static constexpr double budget = 1.0 / 30;      ///< seconds a frame may take while something changes
  static constexpr double rest = 0.15;            ///< seconds without a change until it is refined

  void changed(double now) { last_change_ = now; }
  /// Pixels are divided by this in each direction: 1, 2 or 4.
  int divider(double now) const { return moving(now) ? divider_ : 1; }
  bool moving(double now) const { return now - last_change_ < rest; }
  double rests_at() const { return last_change_ + rest; }
  /// A drawing at `divider` took so many seconds: what the next change will use.
  void took(double seconds, int divider);

 private:
  double last_change_ = -1;
  int divider_ = 1;
};

}  // namespace lumenshop
