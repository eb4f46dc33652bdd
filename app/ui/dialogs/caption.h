#pragma once

#include <QString>

class QLabel;
class QWidget;

namespace app {

/// Returns a text in small letters that wraps.
QLabel *makeCaption(const QString &text, QWidget *parent);

}
