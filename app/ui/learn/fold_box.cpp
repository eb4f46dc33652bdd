#include "app/ui/learn/fold_box.h"

#include "app/ui/learn/narration_text.h"

#include <QKeyEvent>
#include <QPainter>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int foldArrow = 14;
constexpr int foldedLeft = foldArrow + 5; ///< px: the text below is aligned with the title
constexpr int titlePadding = 4;           ///< px, above and below

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
    const QRect room(0, 0, std::max(1, width - foldedLeft), 10'000);
    return 2 * titlePadding + QFontMetrics(m_theme.ui(13, QFont::Medium))
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
        .paint(&painter, QRect(0, titlePadding + (line - foldArrow) / 2, foldArrow, foldArrow));
    painter.setFont(font);
    painter.setPen(ink);
    painter.drawText(rect().adjusted(foldedLeft, titlePadding, 0, 0), Qt::TextWordWrap | Qt::AlignLeft,
                     text());
}

FoldBox::FoldBox(const QString &title, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_theme(theme), m_title(new WhyButton(title, theme, this)),
      m_content(new QWidget(this)), m_column(new QVBoxLayout(m_content))
{
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    m_content->setSizePolicy(policy);
    m_content->hide();
    m_column->setContentsMargins(foldedLeft, 2, 0, 6);
    m_column->setSpacing(2);
    auto *all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addWidget(m_title);
    all->addWidget(m_content);
    connect(m_title, &QAbstractButton::toggled, this, [this](bool open) {
        m_content->setVisible(open);
        emit unfolded(open);
    });
}

void FoldBox::showTitle(const QString &title, bool isDone, const QString &spoken)
{
    m_title->setText(isDone ? title + QStringLiteral(" ✓") : title);
    m_title->setAccessibleName(isDone ? spoken : title);
    m_title->updateGeometry();
}

NarrationText *FoldBox::addText(const QString &name, const QString &text)
{
    auto *made = new NarrationText(m_theme, m_content, NarrationText::Kind::aside);
    made->setObjectName(name);
    made->setText(text);
    m_column->addWidget(made);
    return made;
}

}
