#pragma once

#include "app/model/sandbox/sandbox_editor.h"

#include <QWidget>

class QLabel;
class QLineEdit;

namespace app {

/// The row of the sandbox panel with the name of a point. A name that the point cannot have stays in the field, with a
/// sentence below it, until the learner corrects it or leaves the field.
class NameRow : public QWidget
{
    Q_OBJECT

public:
    /// `section` is the title of the properties of the point.
    NameRow(SandboxEditor &editor, int point, const QString &section, QWidget *parent = nullptr);

    QLineEdit *field() const { return m_field; }
    /// Sets the title of the properties of the point.
    void setSection(const QString &section);
    /// Shows the present name, unless the learner is typing another one.
    void refresh();
    /// Returns why the name in the field was rejected; empty if it was not.
    QString whyNot() const;
    /// From now on, the field changes nothing. The point may be another one by now.
    void discard();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QString typed() const;
    void enter();
    void leave();
    void showWhyNot(const QString &sentence);
    /// Shows the current name of the point again. What was typed is lost.
    void reset();

    SandboxEditor &m_editor;
    int m_point;
    QLineEdit *m_field;
    QLabel *m_whyNot;
    bool m_byMouse = false; ///< whether a click gave the field the focus
};

}
