package faultline.gui.gallery;

import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.Theme;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.RenderingHints;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;

/** Renders an example: its thumbnail, and its title below. */
final class ExampleCard extends JPanel implements ListCellRenderer<Example> {

    static final Dimension SIZE = new Dimension(Example.WIDTH + 28, Example.HEIGHT + 54);

    private final JLabel title = new JLabel("", JLabel.CENTER);
    /** The example to be painted; null before the first. */
    private transient Example example;

    private boolean highlighted;

    ExampleCard() {
        super(new BorderLayout(0, 6));
        setBorder(BorderFactory.createEmptyBorder(14, 14, 8, 14));
        add(new ThumbnailView(), BorderLayout.CENTER);
        add(title, BorderLayout.SOUTH);
    }

    @Override
    public Component getListCellRendererComponent(
            JList<? extends Example> list, Example value, int index, boolean selected, boolean focused) {
        example = value;
        highlighted = selected;
        title.setText(value.title());
        title.setForeground(
                selected
                        ? Theme.currentColours().onAccent()
                        : Theme.currentColours().text());
        setBackground(list.getBackground());
        setToolTipText(value.description());
        getAccessibleContext().setAccessibleName(value.title());
        getAccessibleContext().setAccessibleDescription(value.description());
        return this;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        if (highlighted) {
            Antialiasing.paint(graphics, g -> {
                g.setColor(Theme.currentColours().accent());
                g.fillRoundRect(4, 4, getWidth() - 8, getHeight() - 8, 12, 12);
            });
        }
    }

    /** Paints the thumbnail at the resolution of the screen. */
    private final class ThumbnailView extends JComponent {
        @Override
        protected void paintComponent(Graphics graphics) {
            Antialiasing.paint(graphics, g -> {
                g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
                if (example != null) {
                    g.drawImage(example.thumbnail(), 0, 0, getWidth(), getHeight(), null);
                }
                Color edge = highlighted
                        ? Theme.currentColours().onAccent()
                        : Theme.currentColours().line();
                g.setColor(edge);
                g.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
            });
        }
    }
}
