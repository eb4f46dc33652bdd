#include "app/ui/learn/step_buttons.h"

#include "app/ui/theme/icon_button.h"

#include <QHBoxLayout>

namespace app {

StepButtons::StepButtons(const Theme &theme, QWidget *parent)
    : QWidget(parent), m_back(new QPushButton(this)), m_next(new StepButton(this))
{
    m_back->setObjectName("back");
    m_back->setFixedSize(36, 32);
    m_back->setIconSize({16, 16});
    m_back->setFocusPolicy(Qt::TabFocus);
    showIcon(*m_back, "left", theme, &Tokens::ink);
    m_next->setObjectName("next");
    m_next->showArrow(theme);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 16, 14);
    row->setSpacing(8);
    row->addWidget(m_back);
    row->addWidget(m_next, 1);
}

}
