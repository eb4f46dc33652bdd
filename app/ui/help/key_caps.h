#pragma once

#include "app/ui/theme/theme.h"

#include <QKeySequence>
#include <QWidget>

namespace app {

/// A widget that draws keys as key caps: "Shift" "→" or "+".
class KeyCaps : public QWidget
{
    Q_OBJECT

public:
    KeyCaps(const QList<QKeySequence> &keys, const Theme &theme, QWidget *parent = nullptr);
    /// Draws a single cap with any text, for mouse gestures.
    KeyCaps(const QString &text, const Theme &theme, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    struct Piece
    {
        QString text;
        bool isCap = true; ///< otherwise a word between caps
    };

    void finish();
    double widthOf(const Piece &piece) const;

    const Theme &m_theme;
    std::vector<Piece> m_pieces;
};

}
