#include "reports/eval/eval_written.hpp"

#include "reports/eval/evaluate.hpp"
#include "reports/eval/numbers.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace halfway::reports {
namespace {

using nlohmann::ordered_json;

std::string in_json(const ordered_json& value) {
  return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

/// One list for each of what is wanted, as far as they are written.
class Lists {
 public:
  explicit Lists(const EvalRequest& request) : request_(&request) {}

  void add(const EvalAnswer& answer) {
    begin_item();
    if (request_->strain) append_row(strain_, answer.strain);
    if (request_->loads) append_row(loads_, answer.loads);
    if (request_->tangent) append_rows(tangent_, answer.tangent);
    if (answer.energy) append_number(energy_, *answer.energy);
  }

  void add_null() {
    begin_item();
    for (std::string* list : {&strain_, &loads_, &tangent_, &energy_}) *list += "null";
  }

  void append_to(std::string& out) const {
    if (request_->strain) append_member(out, R"(,"strain":)", strain_);
    if (request_->loads) append_member(out, R"(,"loads":)", loads_);
    if (request_->tangent) append_member(out, R"(,"tangent":)", tangent_);
    if (!request_->energy) return;
    if (request_->entry->has_potential(request_->spec.kind))
      append_member(out, R"(,"energy":)", energy_);
    else
      out += R"(,"energy":null)";
  }

 private:
  void begin_item() {
    if (has_items_) {
      for (std::string* list : {&strain_, &loads_, &tangent_, &energy_}) *list += ',';
    }
    has_items_ = true;
  }

  void append_member(std::string& out, const char* name, const std::string& items) const {
    out += name;
    if (request_->is_block) out += '[';
    out += items;
    if (request_->is_block) out += ']';
  }

  const EvalRequest* request_;
  bool has_items_ = false;
  std::string strain_, loads_, tangent_, energy_;
};

/// Of one pose among others.
std::string error_at(std::size_t pose, const reference::Refusal& why) {
  return in_json({{"pose", pose}, {"code", why.code}, {"message", why.what()}});
}

std::string written_notes(const reference::Document& document) {
  ordered_json notes = document.notes;
  if (document.more_notes > 0) notes.push_back(fmt::format("and {} more of their kind", document.more_notes));
  return in_json(notes);
}

}  // namespace

std::string written_answer(std::string_view id, const EvalRequest& request,
                           const reference::Document& document) {
  const Evaluator evaluate(request);
  Lists lists(request);
  std::string errors;
  EvalAnswer answer;
  for (std::size_t i = 0; i < request.poses.size(); ++i) {
    const auto refused = evaluate(request.poses[i], answer);
    if (!refused) {
      lists.add(answer);
      continue;
    }
    if (!request.is_block) throw *refused;
    lists.add_null();
    errors += (errors.empty() ? "" : ",") + error_at(i, *refused);
  }
  std::string out = fmt::format("{{\"id\":{}", id);
  lists.append_to(out);
  if (!errors.empty()) out += R"(,"errors":[)" + errors + ']';
  if (!document.notes.empty()) out += R"(,"notes":)" + written_notes(document);
  return out + '}';
}

std::string written_refusal(std::string_view id, std::string_view code, std::string_view message,
                            std::string_view field) {
  const ordered_json error = {
      {"code", code}, {"message", message}, {"field", field.empty() ? ordered_json() : ordered_json(field)}};
  return fmt::format(R"({{"id":{},"error":{}}})", id, in_json(error));
}

}  // namespace halfway::reports
