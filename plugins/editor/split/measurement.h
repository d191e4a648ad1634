/// What a frame costs with a cut in image space and without it: drawn aside from the window, some frames each.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <lumen/editor.h>

class Measurement {
 public:
  /// Of a view; `surface` is drawn as it is, then without `splitter`.
  Measurement(std::string view, std::string surface, std::string splitter);

  /// The next frame, or a part of it. False once all are drawn. Throws Error.
  bool step(lumen::Workbench& workbench);
  float progress() const { return float(drawn_) / float(2 * frames); }

  const std::string surface, splitter;
  double with_cut() const { return median(samples_[0]); }     ///< milliseconds of a frame
  double without_cut() const { return median(samples_[1]); }

 private:
  static constexpr int frames = 6;      ///< the first has programs and buffers to make and does not count
  static double median(std::vector<double> samples);

  std::string view_;
  std::unique_ptr<lumen::Trial> trial_;
  std::vector<double> samples_[2];
  int drawn_ = 0;
};
