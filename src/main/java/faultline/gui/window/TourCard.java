package faultline.gui.window;

import faultline.gui.action.Keystrokes;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;

/**
 * The tour of the window: a card in the canvas that explains one step at a time and marks the control concerned. The
 * program can be used while it is open. Escape closes it. On a small canvas the text scrolls, with the mouse wheel and
 * with Up and Down.
 */
final class TourCard extends JPanel {

    private static final int GAP = 8;
    /** The width where there is room, at the normal text size, pixels. */
    private static final int WIDTH = 420;

    /** A step of the tour: the end of the keys of its texts, and the control to use. */
    record TourStep(String key, JComponent target) {}

    private final transient List<TourStep> steps;
    private final transient Consumer<JComponent> marker;
    private final JTextArea title = UiText.wrappedText();
    private final JTextArea text = UiText.wrappedText();
    private final JScrollPane scroll = ScreenFit.scrolling(text);
    private final JButton back = UiText.button("tour.back");
    private final JButton next = UiText.button("tour.next");
    private final JButton close = UiText.button("dialog.close");
    private int shown;

    /**
     * Creates a card that is not visible; {@code marker} marks a control in the window, or none if it receives null.
     */
    TourCard(List<TourStep> steps, Consumer<JComponent> marker) {
        super(new BorderLayout(0, GAP));
        this.steps = steps;
        this.marker = marker;
        close.addActionListener(event -> close());
        back.addActionListener(event -> show(shown - 1));
        next.addActionListener(event -> show(shown + 1));
        registerKeyboardAction(event -> close(), KeyStroke.getKeyStroke("ESCAPE"), WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
        registerKeyboardAction(event -> scrollBy(-1), KeyStroke.getKeyStroke("UP"), WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
        registerKeyboardAction(
                event -> scrollBy(1), KeyStroke.getKeyStroke("DOWN"), WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
        RefreshSteps.add(title, RefreshSteps::embolden);
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, GAP, 0));
        buttons.setOpaque(false);
        List.of(back, next, close).forEach(buttons::add);
        add(title, BorderLayout.NORTH);
        scroll.setViewportBorder(null);
        scroll.setOpaque(false);
        scroll.getViewport().setOpaque(false);
        add(scroll, BorderLayout.CENTER);
        add(buttons, BorderLayout.SOUTH);
        // Clicks must not reach the canvas below.
        addMouseListener(new MouseAdapter() {});
        setVisible(false);
        RefreshSteps.add(this, card -> {
            if (card.isVisible()) {
                card.updateTexts();
            }
        });
    }

    /** Shows the first step and gives the focus to the button for the next one. */
    void start() {
        setVisible(true);
        show(0);
    }

    private void close() {
        Container canvas = getParent();
        setVisible(false);
        marker.accept(null);
        canvas.requestFocusInWindow();
    }

    private void scrollBy(int direction) {
        JScrollBar bar = scroll.getVerticalScrollBar();
        bar.setValue(bar.getValue() + direction * bar.getUnitIncrement(direction));
    }

    private void show(int step) {
        shown = step;
        updateTexts();
        back.setEnabled(step > 0);
        next.setEnabled(step < steps.size() - 1);
        (next.isEnabled() ? next : close).requestFocusInWindow();
        reveal(steps.get(step).target());
        marker.accept(steps.get(step).target());
        getParent().revalidate();
    }

    /** Returns the size that shows all texts, or as much of them as fits, pixels. */
    Dimension sizeWithin(Dimension available) {
        int width = Math.min(TextSize.scaled(WIDTH), available.width);
        // The height of a text that wraps depends on its width.
        for (JTextArea wrapped : List.of(title, text)) {
            wrapped.setSize(width - getInsets().left - getInsets().right, Short.MAX_VALUE);
        }
        return new Dimension(width, Math.min(getPreferredSize().height, available.height));
    }

    private void updateTexts() {
        TourStep now = steps.get(shown);
        String name = Messages.get("tour." + now.key());
        title.setText(Messages.get("tour.title", Integer.toString(shown + 1), Integer.toString(steps.size()), name));
        text.setText(Keystrokes.withMenuModifier(Messages.get("tour." + now.key() + ".text")));
        text.setCaretPosition(0);
        getAccessibleContext().setAccessibleName(title.getText());
        getAccessibleContext().setAccessibleDescription(text.getText());
    }

    /** Selects the tabs that contain a control and scrolls to it. */
    private static void reveal(JComponent control) {
        for (Container part = control; part.getParent() != null; part = part.getParent()) {
            if (part.getParent() instanceof JTabbedPane tabs) {
                tabs.setSelectedComponent(part);
            }
        }
        SwingUtilities.invokeLater(
                () -> control.scrollRectToVisible(new Rectangle(control.getWidth(), control.getHeight())));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        Color edge = Theme.currentColours().accent();
        setBackground(Theme.currentColours().field());
        setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createLineBorder(edge, 2), BorderFactory.createEmptyBorder(GAP, GAP, GAP, GAP)));
    }
}
