#pragma once

#include <QString>

#include <stdexcept>

namespace app {

/// What a file, an argument or a parameter was refused for: one clear sentence with place and remedy.
class Refusal : public std::runtime_error
{
public:
    explicit Refusal(const QString &sentence) : std::runtime_error(sentence.toStdString()) {}
    QString sentence() const { return QString::fromUtf8(what()); }
};

}
