#pragma once

#include <QWidget>

#include <cstdint>

class QLineEdit;

namespace app {

/// Asks for the name of a film, and whether what has that name already may be written over.
class FilmName : public QWidget
{
    Q_OBJECT

public:
    explicit FilmName(QWidget *parent = nullptr);

    QString name() const;
    void setName(const QString &name);
    /// The name in `folder`, with a number where it is taken, as long as no other is given.
    void suggest(const QString &folder, const QString &name);
    QLineEdit &field() const { return *m_field; }

    /// Why a film of these frames is not written without being asked for once more; empty: nothing is in its way, or that may
    /// be written over. @throws Refusal: the name is no film's
    QString objection(std::int64_t from, std::int64_t to) const;
    /// What has this name may be written over, until there is another one.
    void allowReplacing() { m_replaced = name(); }
    bool mayReplace() const { return m_replaced == name() && !m_replaced.isNull(); }
    void forbidReplacing() { m_replaced = {}; }

signals:
    /// Another name, or the same one chosen anew.
    void changed();

private:
    void choose();

    QLineEdit *m_field;
    QString m_suggested; ///< as long as the learner has given no other
    QString m_replaced;  ///< the name that may be written over; null: none
};

}
