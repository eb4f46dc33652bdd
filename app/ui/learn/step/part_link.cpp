#include "app/ui/learn/step/part_link.h"

namespace app {

namespace {

constexpr int boxTitleHeight = 20; ///< px

}

PartLink::PartLink(const QString &text, const QString &tip, QWidget *parent) : QToolButton(parent)
{
    setText(text);
    setToolTip(tip);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setIconSize({14, 14});
    setFocusPolicy(Qt::TabFocus);
    hide();
}

void PartLink::keepPlace(bool isKept)
{
    QSizePolicy policy = sizePolicy();
    policy.setRetainSizeWhenHidden(isKept);
    setSizePolicy(policy);
}

bool PartLink::isTitleIn(const QWidget &view, const QWidget &box)
{
    const int top = box.mapTo(&view, QPoint()).y();
    return top >= 0 && top + boxTitleHeight <= view.height();
}

}
