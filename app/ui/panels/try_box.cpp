#include "app/ui/panels/try_box.h"

#include "app/ui/panels/narration_text.h"
#include "app/ui/panels/prose.h"
#include "app/ui/panels/try_row.h"

#include <QGridLayout>
#include <QToolButton>

namespace app {

namespace {

constexpr int buttonSize = 24;
constexpr int hintLeft = 25; ///< under the text of the row

}

TryBox::TryBox(const lessons::Try &what, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_theme(theme), m_row(new TryRow(what.text, theme, this))
{
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(0);
    grid->setColumnStretch(0, 1);
    grid->addWidget(m_row, 0, 0);
    if (what.hint.isEmpty())
        return;
    m_button = new QToolButton(this);
    m_button->setObjectName("hint");
    m_button->setCheckable(true);
    m_button->setFixedSize(buttonSize, buttonSize);
    m_button->setIconSize({14, 14});
    m_button->setFocusPolicy(Qt::TabFocus);
    m_button->setAccessibleName(tr("Hint: %1").arg(plainText(what.text)));
    m_hint = new NarrationText(theme, this, NarrationText::Kind::aside);
    m_hint->setObjectName("hintText");
    m_hint->setText(what.hint);
    m_hint->hide();
    grid->addWidget(m_button, 0, 1, Qt::AlignTop);
    auto *indented = new QVBoxLayout; // takes no room while the hint is hidden
    indented->setContentsMargins(hintLeft, 0, 0, 4);
    indented->addWidget(m_hint);
    grid->addLayout(indented, 1, 0, 1, 2);
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
