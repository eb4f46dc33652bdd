#pragma once

#include <QString>

#include <functional>

namespace app {

class Notice;

/// Does `deed`. A Refusal or a sim::Error is shown by `notice`, in the sentence `failure` with the reason as %1. Returns
/// whether it was done.
bool attempt(Notice &notice, const QString &failure, const std::function<void()> &deed);

}
