#include "app/ui/learn/why_box.h"

#include "app/ui/learn/why_text.h"

#include <QVBoxLayout>

namespace app {

WhyBox::WhyBox(const lessons::Why &why, const Theme &theme, QWidget *parent)
    : FoldBox(why.question, theme, parent), m_why(why)
{
}

void WhyBox::fill()
{
    auto *answer = new WhyText(m_why, theme(), content());
    column().addWidget(answer);
    connect(answer, &WhyText::highlightsChanged, this, &WhyBox::highlightsChanged);
}

}
