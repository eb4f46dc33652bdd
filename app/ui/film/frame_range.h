#pragma once

#include <QObject>

class QGridLayout;
class QSpinBox;
class QWidget;

namespace app {

/// Returns a field for a number of frames, from 0 to the most that a run can have.
QSpinBox *makeFrameBox(const QString &name, const QString &help, QWidget *parent);

/// Adds a row with a label and a field to `form`. The mnemonic of `caption` moves the keyboard focus to `buddy`.
void addRow(QGridLayout &form, const QString &caption, QWidget *field, QWidget *buddy);

/// The two fields of a form that say which frames are exported.
class FrameRange : public QObject
{
    Q_OBJECT

public:
    /// Adds the fields to `form`, whose widget becomes their parent. The texts are their tooltips.
    FrameRange(QGridLayout &form, const QString &firstHelp, const QString &lastHelp);

    int first() const;
    int last() const;
    void set(int first, int last);

signals:
    void changed();

private:
    QSpinBox *m_first;
    QSpinBox *m_last;
};

}
