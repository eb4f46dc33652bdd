#pragma once

#include <QWidget>

#include <cstdint>

class QLineEdit;

namespace app {

/// A field for the name of a film. It asks before an existing file is replaced.
class FilmName : public QWidget
{
    Q_OBJECT

public:
    explicit FilmName(QWidget *parent = nullptr);

    QString name() const;
    void setName(const QString &name);
    /// Suggests a name in `folder`, with a number if it is taken. It replaces only an earlier suggestion, not
    /// a name that the learner entered.
    void suggest(const QString &folder, const QString &name);
    QLineEdit &field() const { return *m_field; }

    /// Returns the sentence that asks the learner to confirm a film of these frames, because it would replace a file. Empty
    /// if there is no such file, or if it may be replaced.
    /// @throws UserError if the name is not a film name
    QString objection(std::int64_t from, std::int64_t to) const;
    /// Allows existing files with this name to be replaced, until the name changes.
    void allowReplacing() { m_replaced = name(); }
    bool mayReplace() const { return m_replaced == name() && !m_replaced.isNull(); }
    void forbidReplacing() { m_replaced = {}; }

signals:
    /// The name has changed, or the same name was chosen again.
    void changed();

private:
    void choose();

    QLineEdit *m_field;
    QString m_suggested; ///< the last suggestion
    QString m_replaced;  ///< the name whose files may be replaced; null: none
};

}
