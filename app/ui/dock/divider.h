#pragma once

#include <QFrame>

namespace app {

/// A thin line between two parts of a panel.
inline QFrame *divider(QWidget *parent)
{
    auto *line = new QFrame(parent);
    line->setObjectName("divider");
    line->setFixedHeight(1);
    return line;
}

}
