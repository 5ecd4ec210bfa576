#pragma once
/// A scheme's record as a web page.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "limn/base/error.h"

namespace limn::report {

/// The page `page` with the record in it: in the place of null in its one element
/// <script type="application/json" id="record">null</script>. Fails where the page has no such
/// place.
[[nodiscard]] Result<std::string> page_with_record(std::string_view page,
                                                   const nlohmann::ordered_json& record);

/// A page of the record (report/page/page_record.h) alone, to be read: tables, without a script.
/// The record is in it as JSON, too.
[[nodiscard]] std::string static_page(const nlohmann::ordered_json& record);

}  // namespace limn::report
