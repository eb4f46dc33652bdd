#include "app/ui/panels/try_box.h"

#include "app/ui/panels/narration_text.h"
#include "app/ui/panels/prose.h"
#include "app/ui/panels/try_row.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr QSize buttonSize{24, 24};
constexpr QPoint buttonPlace{0, 22}; ///< under the box of the row, where its text needs no room
constexpr int leastHeight = 46;      ///< of a row with a button
constexpr int hintLeft = 25;         ///< from the row’s left: under the text of the row

}

TryBox::TryBox(const lessons::Try &what, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_theme(theme), m_row(new TryRow(what.text, theme, this))
{
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(left, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_row);
    if (what.hint.isEmpty())
        return;
    m_button = new QToolButton(this);
    m_button->setObjectName("hint");
    m_button->setCheckable(true);
    m_button->setIconSize({14, 14});
    m_button->setGeometry(QRect(buttonPlace, buttonSize));
    m_row->setMinimumHeight(leastHeight);
    m_button->setFocusPolicy(Qt::TabFocus);
    m_button->setAccessibleName(tr("Hint: %1").arg(plainText(what.text)));
    m_hint = new NarrationText(theme, this, NarrationText::Kind::aside);
    m_hint->setObjectName("hintText");
    m_hint->setText(what.hint);
    m_hint->hide();
    auto *indented = new QVBoxLayout; // takes no room while the hint is hidden
    indented->setContentsMargins(hintLeft, 0, 0, 4);
    indented->addWidget(m_hint);
    column->addLayout(indented);
    connect(m_button, &QToolButton::clicked, this, [this](bool shown) {
        showHint(shown);
        emit hintAsked(shown);
    });
    connect(&theme, &Theme::changed, this, &TryBox::dress);
    dress();
}

void TryBox::dress()
{
    m_button->setIcon(m_theme.icon("hint"));
    m_button->setToolTip(m_button->isChecked() ? tr("Put the hint away") : tr("Show a hint (H)"));
}

void TryBox::setDone(bool done)
{
    m_row->setDone(done);
    if (!m_button)
        return;
    if (done)
        showHint(false);
    m_button->setVisible(!done);
    m_row->setMinimumHeight(done ? 0 : leastHeight);
}

bool TryBox::hasHint() const
{
    return m_button && !m_row->isChecked();
}

bool TryBox::showsHint() const
{
    return m_hint && !m_hint->isHidden();
}

void TryBox::showHint(bool shown)
{
    if (!m_button)
        return;
    m_button->setChecked(shown);
    m_hint->setVisible(shown);
    dress();
}

}
