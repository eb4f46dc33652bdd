#pragma once

#include <QString>

#include <optional>

namespace app {

/// What `springstep hardcases` is asked.
struct HardCasesRequest
{
    std::optional<QString> only; ///< the id of the one case to run; else all
    bool asJson = false;
    bool isFull = false; ///< runs of the size that their stories tell; else short ones
};

/// `springstep hardcases`: runs each case under each method. Returns the exit code: exitNo if a method fails a case
/// that it claims.
int hardCases(const HardCasesRequest &request);

}
