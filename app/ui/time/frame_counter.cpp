#include "app/ui/time/frame_counter.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QRegularExpressionValidator>
#include <QToolTip>

#include <cmath>

namespace app {

namespace {

constexpr double captionGap = 6.0;
constexpr double detailGap = 8.0;
constexpr int editorWidth = 92;
constexpr int editorHeight = 28;
constexpr int lineHeight = 28;

}

FrameCounter::FrameCounter(const Theme &theme, QWidget *parent) : QAbstractButton(parent), m_theme(theme)
{
    setObjectName("frame");
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setText(tr("%1 %2").arg(tr("Frame"), m_number));
    connect(this, &QAbstractButton::clicked, this, &FrameCounter::edit);
}

void FrameCounter::show(std::int64_t frame, const QString &detail, const QString &brief)
{
    const QString number = QString::number(frame);
    if (number == m_number && detail == m_detail && brief == m_brief)
        return;
    const QSize before = sizeHint();
    m_number = number;
    m_detail = detail;
    m_brief = brief;
    setText(tr("%1 %2").arg(tr("Frame"), number) + (detail.isEmpty() ? QString() : ' ' + detail));
    setAccessibleName(text());
    if (sizeHint() != before) {
        updateGeometry();
        emit resized();
    }
    update();
}

void FrameCounter::setBrief(bool brief)
{
    if (brief == m_isBrief)
        return;
    m_isBrief = brief;
    updateGeometry();
    update();
}

QString FrameCounter::shownDetail() const
{
    return m_isBrief ? m_brief : m_detail;
}

double FrameCounter::captionWidth() const
{
    return QFontMetricsF(m_theme.ui(12)).horizontalAdvance(tr("Frame"));
}

double FrameCounter::digitWidth() const
{
    return QFontMetricsF(m_theme.ui(20, QFont::DemiBold)).horizontalAdvance('0');
}

double FrameCounter::numberWidth() const
{
    return m_editor ? editorWidth : digitWidth() * static_cast<double>(m_number.size());
}

QSize FrameCounter::sizeHint() const
{
    double width = captionWidth() + captionGap + numberWidth();
    if (!shownDetail().isEmpty())
        width += detailGap + QFontMetricsF(m_theme.ui(13)).horizontalAdvance(shownDetail());
    return {static_cast<int>(std::ceil(width)), lineHeight};
}

void FrameCounter::paintEvent(QPaintEvent *)
{
    constexpr double baseline = 21.0;
    const Tokens &t = m_theme.tokens();
    QPainter painter(this);
    painter.setFont(m_theme.ui(12));
    painter.setPen(t.ink3);
    painter.drawText(QPointF(0, baseline), tr("Frame"));
    double x = captionWidth() + captionGap;
    if (!m_editor) {
        const QFont font = m_theme.ui(20, QFont::DemiBold);
        const QFontMetricsF metrics(font);
        painter.setFont(font);
        painter.setPen(t.ink);
        const double cell = digitWidth();
        for (qsizetype i = 0; i < m_number.size(); ++i) {
            const double aside = (cell - metrics.horizontalAdvance(m_number[i])) / 2;
            painter.drawText(QPointF(x + cell * static_cast<double>(i) + aside, baseline),
                             QString(m_number[i]));
        }
    }
    x += numberWidth() + detailGap;
    painter.setFont(m_theme.ui(13));
    painter.setPen(t.ink2);
    painter.drawText(QPointF(x, baseline), shownDetail());
}

void FrameCounter::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        edit();
    else
        QAbstractButton::keyPressEvent(event);
}

void FrameCounter::edit()
{
    if (m_editor) {
        m_editor->setFocus();
        return;
    }
    m_before = QApplication::focusWidget();
    m_editor = new QLineEdit(m_number, this);
    m_editor->setObjectName("goToFrame");
    m_editor->setAcceptDrops(false); // the window takes files
    m_editor->setAccessibleName(tr("Go to frame"));
    m_editor->setToolTip(tr("Press Enter to go there, Esc to cancel"));
    m_editor->setValidator(
        new QRegularExpressionValidator(QRegularExpression("\\s*\\d{0,20}\\s*"), m_editor));
    m_editor->installEventFilter(this);
    connect(m_editor, &QLineEdit::inputRejected, this, &FrameCounter::refuse);
    m_editor->setGeometry(static_cast<int>(captionWidth() + captionGap), (lineHeight - editorHeight) / 2,
                          editorWidth, editorHeight);
    m_editor->selectAll();
    m_editor->QWidget::show();
    m_editor->setFocus();
    updateGeometry();
    emit resized();
    update();
}

void FrameCounter::take()
{
    bool isNumber = false;
    const qlonglong frame = m_editor->text().trimmed().toLongLong(&isNumber);
    if (!isNumber || frame > lastFrame) {
        m_editor->selectAll();
        refuse();
        return;
    }
    leave();
    emit frameRequested(frame);
}

void FrameCounter::refuse()
{
    const QString sentence = tr("A frame is a whole number from 0 to %1.").arg(lastFrame);
    QToolTip::showText(m_editor->mapToGlobal(QPoint(0, m_editor->height())), sentence, m_editor);
    emit refused(sentence);
}

void FrameCounter::leave()
{
    if (!m_editor)
        return;
    QLineEdit *editor = m_editor;
    m_editor = nullptr;
    if (editor->hasFocus() && m_before && m_before != editor)
        m_before->setFocus();
    editor->removeEventFilter(this);
    editor->hide();
    editor->deleteLater();
    QToolTip::hideText();
    updateGeometry();
    emit resized();
    update();
}

bool FrameCounter::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_editor)
        return QAbstractButton::eventFilter(watched, event);
    const QEvent::Type type = event->type();
    // The context menu takes the focus and returns it.
    if (type == QEvent::FocusOut && static_cast<QFocusEvent *>(event)->reason() != Qt::PopupFocusReason)
        leave();
    if (type != QEvent::KeyPress && type != QEvent::ShortcutOverride)
        return false;
    const int key = static_cast<QKeyEvent *>(event)->key();
    const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (key != Qt::Key_Escape && !isEnter)
        return false;
    // Escape is a shortcut of the window, and Enter on the counter opens the editor. While a number is typed, both
    // belong to the editor.
    event->accept();
    if (type == QEvent::KeyPress)
        isEnter ? take() : leave();
    return true;
}

}
