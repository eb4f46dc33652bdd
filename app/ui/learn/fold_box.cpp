#include "app/ui/learn/fold_box.h"

#include "app/ui/dock/panel_parts.h"
#include "app/ui/learn/narration_text.h"

#include <QAbstractTextDocumentLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int foldArrow = 14;
constexpr int foldedLeft = foldArrow + 5; ///< px: the text below is aligned with the title
constexpr int titlePadding = 4;           ///< px, above and below

/// Returns the height of a line of a title, px.
int titleLine(const Theme &theme)
{
    return QFontMetrics(theme.ui(13, QFont::Medium)).height();
}

}

WhyButton::WhyButton(const QString &question, const Theme &theme, QWidget *parent)
    : QAbstractButton(parent), m_theme(theme)
{
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(this, &QAbstractButton::toggled, this, &WhyButton::describeState);
    connect(&theme, &Theme::changed, this, &WhyButton::applyTheme);
    describeState();
    setMarkdown(question);
}

void WhyButton::setMarkdown(const QString &text)
{
    if (text == m_markdown)
        return;
    m_markdown = text;
    const QString plain = plainText(text);
    setText(plain);
    setAccessibleName(plain);
    applyTheme();
    updateGeometry();
}

void WhyButton::applyTheme()
{
    const Tokens &tokens = m_theme.tokens();
    const QColor ink = underMouse() ? tokens.ink : tokens.ink2;
    const double line = titleLine(m_theme);
    setProse(m_document, m_markdown, {13, line, 4, ink, tokens.ink, QFont::Bold, 0, QFont::Medium}, m_theme);
    m_heights.forget();
    update();
}

void WhyButton::describeState()
{
    setToolTip(isChecked() ? tr("Hide the answer") : tr("Show the answer"));
    setAccessibleDescription(isChecked() ? tr("open") : tr("folded"));
}

int WhyButton::heightForWidth(int width) const
{
    return 2 * titlePadding + m_heights.at(std::max(1, width - foldedLeft), m_document);
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
    applyTheme();
}

void WhyButton::leaveEvent(QEvent *)
{
    applyTheme();
}

void WhyButton::paintEvent(QPaintEvent *)
{
    const QColor ink = underMouse() ? m_theme.tokens().ink : m_theme.tokens().ink2;
    QPainter painter(this);
    m_theme.icon(isChecked() ? "down" : "right", ink)
        .paint(&painter, QRect(0, titlePadding + (titleLine(m_theme) - foldArrow) / 2, foldArrow, foldArrow));
    layOut(m_document, std::max(1, width() - foldedLeft));
    painter.translate(foldedLeft, titlePadding);
    m_document.drawContents(&painter);
}

FoldBox::FoldBox(const QString &title, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_theme(theme), m_title(new WhyButton(title, theme, this)),
      m_content(new QWidget(this)), m_column(new QVBoxLayout(m_content))
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_content->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_content->hide();
    m_column->setContentsMargins(foldedLeft, 2, 0, 6);
    m_column->setSpacing(2);
    QVBoxLayout *all = makeColumn(this);
    all->addWidget(m_title);
    all->addWidget(m_content);
    connect(m_title, &QAbstractButton::toggled, this, [this](bool open) {
        if (open && !m_isFilled)
            fillNow();
        m_content->setVisible(open);
        emit unfolded(open);
    });
}

void FoldBox::fillNow()
{
    m_isFilled = true;
    fill();
    QWidget *before = m_title; // Tab goes from the title to the new widgets, and then to those below the box
    for (QWidget *one : m_content->findChildren<QWidget *>()) {
        if (one->focusPolicy() == Qt::NoFocus)
            continue;
        setTabOrder(before, one);
        before = one;
    }
}

void FoldBox::showTitle(const QString &title, bool isDone, const QString &spoken)
{
    m_title->setMarkdown(isDone ? title + QStringLiteral(" ✓") : title);
    if (isDone)
        m_title->setAccessibleName(spoken);
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
