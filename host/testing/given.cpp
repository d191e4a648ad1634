#include "testing/given.h"

namespace lumenshop {

void Given::give(lumen::DataPointer data) {
  data_ = std::move(data);
  version_.set(version_ + 1);
}

void Given::compute(lumen::Job& job) const {
  if (!data_) return;
  switch (data_->kind()) {
    case lumen::DataKind::mesh: return job.set(mesh, std::static_pointer_cast<const lumen::Mesh>(data_));
    case lumen::DataKind::lines: return job.set(lines, std::static_pointer_cast<const lumen::Lines>(data_));
    case lumen::DataKind::volume: return job.set(volume, std::static_pointer_cast<const lumen::Volume>(data_));
    case lumen::DataKind::image: return job.set(image, std::static_pointer_cast<const lumen::Image>(data_));
  }
}

std::shared_ptr<lumen::Plugin> GivenFactory::create(const std::string& type, lumen::Binding& binding) {
  return type == Given::type ? std::make_shared<Given>(binding) : others_.create(type, binding);
}

bool GivenFactory::has(const std::string& type) const { return type == Given::type || others_.has(type); }
int GivenFactory::generation(const std::string& type) const { return type == Given::type ? 1 : others_.generation(type); }

}  // namespace lumenshop
