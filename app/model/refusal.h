#pragma once

#include "app/model/words.h"

#include <QString>

#include <stdexcept>

namespace app {

/// What a file, an argument or a parameter was refused for: one clear sentence with place and remedy, on one
/// line whatever the names in it are.
class Refusal : public std::runtime_error
{
public:
    explicit Refusal(const QString &sentence) : std::runtime_error(escaped(sentence).toStdString()) {}
    QString sentence() const { return QString::fromUtf8(what()); }
};

}
