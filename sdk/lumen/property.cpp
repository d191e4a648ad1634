#include <lumen/plugin.h>

namespace lumen {

PropertyBase::PropertyBase(Plugin* owner, PropertySpec spec) : owner_(owner), slot_(owner->binding().declare(std::move(spec))) {}
PropertyBase::~PropertyBase() { owner_->binding().retract(slot_); }

std::string_view PropertyBase::id() const { return owner_->binding().spec(slot_).id; }
bool PropertyBase::is_set() const { return owner_->binding().is_set(slot_); }
std::uint64_t PropertyBase::revision() const { return owner_->binding().revision(slot_); }
void PropertyBase::link(const std::string& source, const std::string& expression) { owner_->binding().link(slot_, source, expression); }
void PropertyBase::unlink() { owner_->binding().unlink(slot_); }
const Value& PropertyBase::read() const { return owner_->binding().read(slot_); }
void PropertyBase::write(Value value) { owner_->binding().write(slot_, std::move(value)); }
void PropertyBase::write_default(Value value) { owner_->binding().write_default(slot_, std::move(value)); }

}  // namespace lumen
