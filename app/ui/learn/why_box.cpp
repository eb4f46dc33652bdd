#include "app/ui/learn/why_box.h"

#include "app/ui/learn/why_text.h"

#include <QKeyEvent>
#include <QPainter>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int arrow = 14;
constexpr int whyTextLeft = arrow + 5;
constexpr int whyPadding = 4; ///< px, above and below

}

WhyButton::WhyButton(const QString &question, const Theme &theme, QWidget *parent)
    : QAbstractButton(parent), m_theme(theme)
{
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setText(question);
    setAccessibleName(question);
    setCursor(Qt::PointingHandCursor);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(this, &QAbstractButton::toggled, this, &WhyButton::describeState);
    connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
    describeState();
}

void WhyButton::describeState()
{
    setToolTip(isChecked() ? tr("Hide the answer") : tr("Show the answer"));
    setAccessibleDescription(isChecked() ? tr("open") : tr("folded"));
}

int WhyButton::heightForWidth(int width) const
{
    const QRect room(0, 0, std::max(1, width - whyTextLeft), 10'000);
    return 2 * whyPadding + QFontMetrics(m_theme.ui(13, QFont::Medium))
                                .boundingRect(room, Qt::TextWordWrap | Qt::AlignLeft, text())
                                .height();
}

QSize WhyButton::sizeHint() const
{
    return {200, heightForWidth(std::max(width(), 160))};
}

void WhyButton::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        click();
    else
        QAbstractButton::keyPressEvent(event);
}

void WhyButton::enterEvent(QEnterEvent *)
{
    update();
}

void WhyButton::leaveEvent(QEvent *)
{
    update();
}

void WhyButton::paintEvent(QPaintEvent *)
{
    const QColor ink = underMouse() ? m_theme.tokens().ink : m_theme.tokens().ink2;
    QPainter painter(this);
    const QFont font = m_theme.ui(13, QFont::Medium);
    const int line = QFontMetrics(font).height();
    m_theme.icon(isChecked() ? "down" : "right", ink)
        .paint(&painter, QRect(0, whyPadding + (line - arrow) / 2, arrow, arrow));
    painter.setFont(font);
    painter.setPen(ink);
    painter.drawText(rect().adjusted(whyTextLeft, whyPadding, 0, 0), Qt::TextWordWrap | Qt::AlignLeft,
                     text());
}

WhyBox::WhyBox(const lessons::Why &why, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_button(new WhyButton(why.question, theme, this)),
      m_answer(new WhyText(why, theme, this))
{
    m_answer->hide();
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_button);
    auto *indented = new QVBoxLayout;
    indented->setContentsMargins(whyTextLeft, 2, 0, 6);
    indented->addWidget(m_answer);
    column->addLayout(indented);
    connect(m_answer, &WhyText::highlightsChanged, this, &WhyBox::highlightsChanged);
    connect(m_button, &QAbstractButton::toggled, this, [this](bool open) {
        m_answer->setVisible(open);
        emit unfolded(open);
    });
}

}
