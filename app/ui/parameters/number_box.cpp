#include "app/ui/parameters/number_box.h"

#include "app/model/text/numbers.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

constexpr QChar minus(0x2212);
constexpr QChar ellipsis(0x2026);
constexpr double farthest = 1e18; ///< outside the range of every parameter
constexpr double large = 1e5;     ///< from here on the field grows: a number that is cut would look smaller
constexpr int besideText = 14;    ///< px
constexpr int mostFigures = 16;
constexpr int keptDecimals = 60; ///< enough that the base class rounds nothing

QString plain(QString text)
{
    text.replace(minus, '-');
    text.replace(',', '.');
    return text.trimmed();
}

}

NumberBox::NumberBox(const lessons::Parameter &parameter, const Theme &theme, QWidget *parent)
    : QDoubleSpinBox(parent), m_min(parameter.min), m_max(parameter.max),
      m_decimals(parameter.isInteger ? 0 : parameter.decimals), m_scale(parameter.scale)
{
    setButtonSymbols(QAbstractSpinBox::NoButtons);
    setFocusPolicy(Qt::StrongFocus); // no wheel focus: scrolling would change the value at once
    setAlignment(Qt::AlignRight);
    setKeyboardTracking(false);
    setLocale(QLocale::c());
    setDecimals(keptDecimals);
    setRange(-farthest, farthest);
    setSingleStep(parameter.isInteger ? 1.0 : std::pow(10.0, -parameter.decimals));
    setFixedSize(width_, height_);
    setFont(theme.mono(13));
    connect(this, &QDoubleSpinBox::valueChanged, this, &NumberBox::chosen);
    connect(this, &QDoubleSpinBox::editingFinished, this, &NumberBox::write);
    connect(qApp, &QApplication::focusChanged, this, &NumberBox::remember);
    lineEdit()->installEventFilter(this);
    lineEdit()->setAcceptDrops(false); // the window takes files
    write();
}

NumberBox::~NumberBox()
{
    // During destruction Qt moves the focus, and this object is no longer a NumberBox by then.
    disconnect(qApp, nullptr, this, nullptr);
}

void NumberBox::show(double value)
{
    if (hasFocus() && lineEdit()->isModified())
        return;
    if (value == this->value() && !m_isEmpty)
        return;
    m_isEmpty = false;
    const QSignalBlocker silent(this);
    setValue(value);
    write(); // setValue() with an equal value does not update the text
}

void NumberBox::showNothing()
{
    if (m_isEmpty || (hasFocus() && lineEdit()->isModified()))
        return;
    m_isEmpty = true;
    const QSignalBlocker silent(this);
    setValue(farthest); // differs from any number that can be typed
    write();
}

QString NumberBox::exactText(double value) const
{
    return writtenNumber(value, m_decimals);
}

QString NumberBox::textFromValue(double value) const
{
    if (m_isEmpty)
        return {};
    const QString exact = exactText(value);
    if (m_inFull || fits(exact))
        return exact;
    if (const QString whole = writtenNumber(value, 0); fits(whole))
        return whole; // without noughts after the point
    for (int figures = mostFigures; m_rounds && figures > 0; --figures) {
        const QString rounded = exactText(QString::number(value, 'g', figures).toDouble());
        if (fits(rounded))
            return rounded;
    }
    return fontMetrics().elidedText(exact, Qt::ElideRight, minimumWidth() - besideText);
}

bool NumberBox::fits(const QString &text) const
{
    return fontMetrics().horizontalAdvance(text) <= minimumWidth() - besideText;
}

int NumberBox::wantedWidth() const
{
    if (m_rounds || m_isEmpty || std::abs(value()) < large)
        return width_;
    return std::clamp(fontMetrics().horizontalAdvance(writtenNumber(value(), 0)) + besideText, width_,
                      widest_);
}

void NumberBox::setRounding(bool rounds)
{
    m_rounds = rounds;
    write();
}

double NumberBox::valueFromText(const QString &text) const
{
    // A text that is cut or unchanged stands for the present value.
    if (text.contains(ellipsis) || plain(text) == plain(exactText(value())) ||
        plain(text) == plain(textFromValue(value())))
        return value();
    bool ok = false;
    const double number = QLocale::c().toDouble(plain(text), &ok);
    return ok && std::isfinite(number) ? std::clamp(number, -farthest, farthest) : value();
}

QValidator::State NumberBox::validate(QString &text, int &) const
{
    if (text.contains(ellipsis))
        return QValidator::Acceptable;
    bool ok = false;
    const double number = QLocale::c().toDouble(plain(text), &ok);
    if (ok && std::isfinite(number))
        return QValidator::Acceptable;
    const QString allowed = "0123456789+-.eE";
    const QString typed = plain(text);
    const bool canBecome =
        std::all_of(typed.begin(), typed.end(), [&](QChar c) { return allowed.contains(c); });
    return canBecome ? QValidator::Intermediate : QValidator::Invalid;
}

double NumberBox::stepFrom(double value, int steps) const
{
    if (m_scale == lessons::Scale::linear || std::abs(value) < singleStep())
        return singleStep();
    // One step down from 100 is 90.
    const double below = steps < 0 ? std::abs(value) * (1.0 - 1e-9) : std::abs(value);
    return std::max(singleStep(), std::pow(10.0, std::floor(std::log10(below) + 1e-12)));
}

void NumberBox::stepBy(int steps)
{
    if (m_isEmpty)
        return; // an empty box has no number to step from
    const double wanted = std::clamp(value() + steps * stepFrom(value(), steps), m_min, m_max);
    setValue(QString::number(wanted, 'f', m_decimals).toDouble());
    selectAll();
}

void NumberBox::write()
{
    setFixedWidth(wantedWidth());
    const QString text = textFromValue(value());
    if (lineEdit()->text() != text)
        lineEdit()->setText(text);
    lineEdit()->setModified(false);
}

void NumberBox::takeTyped()
{
    if (lineEdit()->isModified())
        interpretText();
    write();
}

void NumberBox::remember(QWidget *old, QWidget *now)
{
    if (now != this || old == this)
        return;
    // If the focus moves between number boxes, remember the widget that had it before the first one.
    const auto *other = qobject_cast<const NumberBox *>(old);
    m_before = other ? other->m_before.data() : old;
}

void NumberBox::giveBack()
{
    if (!m_byMouse)
        return;
    if (m_before && m_before->isVisible())
        m_before->setFocus(Qt::OtherFocusReason);
    else
        clearFocus();
}

bool NumberBox::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto &key = static_cast<const QKeyEvent &>(*event);
        if (key.key() == Qt::Key_Space && key.modifiers() == Qt::NoModifier) {
            takeTyped();
            giveBack();
            event->ignore(); // the window handles the key next
            return true;
        }
    }
    return QDoubleSpinBox::event(event);
}

bool NumberBox::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_clickedWindow && event->type() == QEvent::MouseButtonPress) {
        const QPointF place = static_cast<QMouseEvent *>(event)->globalPosition();
        if (!rect().contains(mapFromGlobal(place).toPoint()))
            takeTyped();
    }
    if (watched == lineEdit() && event->type() == QEvent::MouseButtonDblClick) {
        selectAll(); // a line edit would select the digits on one side of the point
        return true;
    }
    if (watched == lineEdit() && event->type() == QEvent::MouseButtonPress) {
        const bool isUntouched = !lineEdit()->isModified() && !lineEdit()->hasSelectedText();
        if (std::exchange(m_isFresh, false) || isUntouched)
            QTimer::singleShot(0, this, &NumberBox::selectAll); // after the press, which moves the cursor
    }
    return QDoubleSpinBox::eventFilter(watched, event);
}

void NumberBox::watchClicks()
{
    // Most widgets take no focus when they are clicked, so the box would keep the typed number for itself.
    m_clickedWindow = window()->windowHandle();
    if (m_clickedWindow)
        m_clickedWindow->installEventFilter(this);
}

void NumberBox::stopWatchingClicks()
{
    if (m_clickedWindow)
        m_clickedWindow->removeEventFilter(this);
    m_clickedWindow.clear();
}

void NumberBox::focusInEvent(QFocusEvent *event)
{
    watchClicks();
    m_inFull = true;
    write();
    QDoubleSpinBox::focusInEvent(event);
    if (event->reason() == Qt::PopupFocusReason)
        return;
    m_isFresh = true;
    if (event->reason() != Qt::ActiveWindowFocusReason)
        m_byMouse = event->reason() == Qt::MouseFocusReason;
    selectAll();
}

void NumberBox::focusOutEvent(QFocusEvent *event)
{
    stopWatchingClicks();
    QDoubleSpinBox::focusOutEvent(event); // commits what was typed
    m_inFull = false;
    write();
}

void NumberBox::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && lineEdit()->isModified()) {
        write();
        selectAll();
        event->accept();
        return;
    }
    QDoubleSpinBox::keyPressEvent(event);
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        giveBack();
}

void NumberBox::wheelEvent(QWheelEvent *event)
{
    // The wheel scrolls the panel unless this box has the focus.
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore();
}

}
