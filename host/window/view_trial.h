/// A view drawn with another technique, without a splitter, or as it is, aside from the window.
#pragma once

#include <lumen/editor.h>

#include "workshop.h"

namespace lumenshop {

class ViewTrial final : public lumen::Trial {
 public:
  /// Of the size of the workshop's own view. Throws Error if the view or the instance is not there or of no use.
  ViewTrial(Workshop& workshop, const std::string& view, const std::string& instance, const std::vector<std::string>& layers);

  bool step() override;
  float progress() const override { return renderer_.progress(); }
  std::shared_ptr<const lumen::Image> layer(const std::string& name) override { return renderer_.layer(name); }
  double milliseconds() const override;
  std::size_t bytes() const override;

 private:
  Workshop& workshop_;
  std::string instance_;
  bool is_technique_ = false;   ///< an occlusion or a transparency: its passes alone are timed
  ViewRenderer renderer_;
};

}  // namespace lumenshop
