#include "app/ui/sandbox/guide_box.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int guideMargin = 16;

}

GuideBox::GuideBox(BuildGuide &guide, QWidget *parent)
    : QFrame(parent), m_guide(guide), m_count(new QLabel(this)), m_text(new QLabel(this))
{
    setObjectName("guide");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("First build"));
    setToolTip(
        tr("With keys: arrow keys move the cross in the picture, Return clicks there, Tab goes to fields and "
           "switches."));
    m_count->setObjectName("caption");
    m_text->setWordWrap(true);
    m_text->setMinimumHeight(3 * m_text->fontMetrics().lineSpacing()); // keeps the content below from jumping
    m_text->setAlignment(Qt::AlignTop);
    auto *row = new QHBoxLayout;
    row->setSpacing(2);
    row->addWidget(m_count, 1);
    const auto add = [&](const QString &text, const QString &tip, void (BuildGuide::*slot)()) {
        auto *button = new QToolButton(this);
        button->setObjectName("flat");
        button->setText(text);
        button->setToolTip(tip);
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QToolButton::clicked, &m_guide, slot);
        row->addWidget(button);
    };
    add(tr("Restart"), tr("Restart the first build with a new scene. Undo brings this one back"),
        &BuildGuide::start);
    add(tr("Leave"), tr("Leave the first build; the scene stays as it is"), &BuildGuide::leave);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(guideMargin, 4, 8, 8);
    column->setSpacing(2);
    column->addLayout(row);
    column->addWidget(m_text);
    connect(&guide, &BuildGuide::changed, this, &GuideBox::refresh);
    refresh();
}

QString GuideBox::text() const
{
    return m_guide.isOn() ? m_text->text() : QString();
}

void GuideBox::refresh()
{
    setVisible(m_guide.isOn());
    if (!m_guide.isOn())
        return;
    const int number = static_cast<int>(m_guide.step()) + 1;
    m_count->setText(number <= BuildGuide::lastStep
                         ? tr("First build: %1 of %2").arg(number).arg(BuildGuide::lastStep)
                         : tr("First build"));
    m_text->setText(m_guide.text());
    setAccessibleDescription(m_guide.text());
}

}
