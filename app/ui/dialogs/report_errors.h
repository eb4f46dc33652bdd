#pragma once

#include <QString>

#include <functional>

namespace app {

class Notice;

/// Runs `action`. If it throws a UserError, a sim::Error or std::bad_alloc, `notice` shows `failure` with the
/// reason as %1. Returns whether it succeeded.
bool attempt(Notice &notice, const QString &failure, const std::function<void()> &action);

}
