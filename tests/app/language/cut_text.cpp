#include "tests/app/language/cut_text.h"

#include "tests/app/language/drawn_text.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyleOptionComboBox>

#include <algorithm>

namespace {

/// Returns the classes from the window to `widget`, for a message.
QString whereIs(const QWidget *widget)
{
    QStringList path;
    for (; widget; widget = widget->parentWidget())
        path.prepend(QString(widget->metaObject()->className()).remove("app::"));
    return path.join('/');
}

/// Returns how many px of the width of a widget are hidden.
int hidden(const QWidget &widget)
{
    return widget.width() - widget.visibleRegion().boundingRect().width();
}

/// Returns how many px a label or button lacks for its text, across or down; 0 if it is large enough.
int lacking(const QWidget &widget)
{
    if (const auto *label = qobject_cast<const QLabel *>(&widget)) {
        if (label->text().isEmpty())
            return 0;
        // 2 px of it are below the letters of the last line.
        return label->wordWrap() ? label->heightForWidth(label->width()) - 2 - label->height()
                                 : label->minimumSizeHint().width() - label->width();
    }
    if (const auto *combo = qobject_cast<const QComboBox *>(&widget)) {
        QStyleOptionComboBox option;
        option.initFrom(combo);
        const QRect field =
            combo->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, combo);
        return combo->fontMetrics().horizontalAdvance(combo->currentText()) - field.width();
    }
    const auto *push = qobject_cast<const QPushButton *>(&widget);
    if (push && !push->text().isEmpty()) // its padding counts, too
        return push->minimumSizeHint().width() - push->width();
    if (const auto *button = qobject_cast<const QAbstractButton *>(&widget)) {
        if (button->hasHeightForWidth()) // its text wraps
            return button->heightForWidth(button->width()) - button->height();
        const QRect text = button->fontMetrics().boundingRect({}, Qt::TextShowMnemonic, button->text());
        return std::max(text.width() - button->width(), text.height() - button->height());
    }
    return 0;
}

/// Returns the texts of a widget as they are drawn, with the ellipsis if the widget shortens them. Labels in the picture, the
/// code and the plots are left out: their tooltips have the whole value.
QStringList seenIn(QWidget &widget)
{
    if (const auto *label = qobject_cast<const QLabel *>(&widget))
        return {label->text()};
    const auto *button = qobject_cast<const QAbstractButton *>(&widget);
    if (button && !button->text().isEmpty())
        return {button->text().remove(QRegularExpression("[\\x{A0}\\x{200E}]"))};
    const bool isList = qobject_cast<const QAbstractItemView *>(widget.parentWidget());
    return isList || widget.inherits("app::MeasureRow") ? drawnBy(widget) : QStringList();
}

/// Returns whether a text may end in an ellipsis although nothing is cut: work in progress ("measuring…"), a value that is
/// not known yet, or a list that stands in full elsewhere.
bool mayEnd(const QString &text)
{
    return text.endsWith(" …") || text == "…" || text.count(", ") > 1 ||
           text == QCoreApplication::translate("app::EffectLedger", "measuring…");
}

QString textOf(const QWidget &widget)
{
    const auto *label = qobject_cast<const QLabel *>(&widget);
    const auto *button = qobject_cast<const QAbstractButton *>(&widget);
    return label ? label->text() : button ? button->text() : QString();
}

}

QStringList cutIn(QWidget &window)
{
    QStringList cut;
    QList<QWidget *> all = window.findChildren<QWidget *>();
    all << &window;
    for (QWidget *widget : all) {
        if (!widget->isVisible() || widget->visibleRegion().isEmpty())
            continue;
        const bool hasText =
            qobject_cast<const QLabel *>(widget) || qobject_cast<const QAbstractButton *>(widget);
        if (const int px = std::max(lacking(*widget), hasText ? hidden(*widget) : 0); px > 0)
            cut << QString("%1 \"%2\": %3 px").arg(whereIs(widget), textOf(*widget)).arg(px);
        for (const QString &text : seenIn(*widget)) {
            if (text.endsWith(QChar(0x2026)) && !mayEnd(text))
                cut << QString("%1: \"%2\"").arg(whereIs(widget), text);
        }
    }
    return cut;
}
