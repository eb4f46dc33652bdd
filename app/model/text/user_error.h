#pragma once

#include "app/model/text/quoting.h"

#include <QString>

#include <stdexcept>

namespace app {

/// An error in a file, an argument or a parameter, for the user. Its message is one clear sentence with place and
/// remedy. The message stays on one line, whatever names it contains.
class UserError : public std::runtime_error
{
public:
    explicit UserError(const QString &sentence) : std::runtime_error(escaped(sentence).toStdString()) {}
    QString sentence() const { return QString::fromUtf8(what()); }
};

}
