package faultline.gui.theme;

import faultline.gui.text.Messages;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.ShortenedText;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Insets;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import javax.swing.text.DefaultCaret;

/** Texts of components that follow the language; see {@link RefreshSteps}. */
public final class UiText {

    /** The maximum width of a name in a menu or a list, pixels at the normal text size. */
    private static final int MAX_NAME_WIDTH = 300;

    private UiText() {}

    /** Returns a name that is shown in a menu or a list, shortened if it would make that too wide. */
    public static String shortName(String name) {
        Font font = UIManager.getFont("MenuItem.font");
        return ShortenedText.of(name, font, DrawContext.FONT_CONTEXT, TextSize.scaled(MAX_NAME_WIDTH));
    }

    /** Creates a label with the text of a key. */
    public static JLabel label(String key) {
        return RefreshSteps.add(new JLabel(), label -> label.setText(Messages.get(key)));
    }

    /**
     * Creates a component for a text that wraps, which cannot be edited and takes no focus. With a number of columns it
     * has their width; without, that of its last layout. A new text does not scroll what contains the component.
     */
    public static JTextArea wrappedText() {
        JTextArea area = new JTextArea() {
            @Override
            public Dimension getPreferredSize() {
                Dimension size = super.getPreferredSize();
                Insets insets = getInsets();
                int wide = getColumns() * getColumnWidth() + insets.left + insets.right;
                return getColumns() == 0 ? size : new Dimension(wide, size.height);
            }
        };
        // Unlike a caret of the look and feel, this one is kept when the text size changes.
        DefaultCaret caret = new DefaultCaret();
        caret.setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        area.setCaret(caret);
        area.setEditable(false);
        area.setFocusable(false);
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        area.setOpaque(false);
        return area;
    }

    /** Creates a text like {@link #wrappedText()} that gets the height of its lines when its width has changed. */
    public static JTextArea wrappedText(String text) {
        JTextArea area = wrappedText();
        area.setText(text);
        area.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                area.revalidate();
            }
        });
        return area;
    }

    /** Creates a button with the text of a key. */
    public static JButton button(String key) {
        return text(new JButton(), key);
    }

    /** Gives a button or check box the text of a key; returns it. */
    public static <B extends AbstractButton> B text(B button, String key) {
        return RefreshSteps.add(button, self -> self.setText(Messages.get(key)));
    }

    /** Gives a menu item the text of a key; the letter after its ampersand is the mnemonic. Returns the item. */
    public static <B extends AbstractButton> B menuText(B item, String key) {
        return RefreshSteps.add(item, self -> setMarkedText(self, Messages.get(key)));
    }

    /** Does the same with a name, which is shortened, in place of the text's placeholder. */
    public static <B extends AbstractButton> B menuText(B item, String key, String name) {
        return RefreshSteps.add(item, self -> setMarkedText(self, Messages.get(key, shortName(name))));
    }

    private static void setMarkedText(AbstractButton item, String marked) {
        int mark = marked.indexOf('&');
        item.setText(marked.replaceFirst("&", ""));
        item.setMnemonic(mark < 0 ? 0 : Character.toUpperCase(marked.charAt(mark + 1)));
        item.setDisplayedMnemonicIndex(mark);
    }

    /** Gives a component the accessible name of a key; returns it. */
    public static <C extends JComponent> C name(C component, String key) {
        return RefreshSteps.add(component, self -> self.getAccessibleContext().setAccessibleName(Messages.get(key)));
    }

    /** Gives a component the tool tip of a key; returns it. */
    public static <C extends JComponent> C tip(C component, String key) {
        return RefreshSteps.add(component, self -> self.setToolTipText(Messages.get(key)));
    }

    /** Gives a component the same text of a key as accessible name and tool tip; returns it. */
    public static <C extends JComponent> C nameAndTip(C component, String key) {
        return tip(name(component, key), key);
    }

    /** Adds a tab with the name of a key and the tool tip of {@code KEY.tip}. */
    public static void addTab(JTabbedPane tabs, String key, JComponent content) {
        tabs.addTab("", content);
        leaveKeysToTabs(content);
        RefreshSteps.add(content, self -> {
            int index = tabs.indexOfComponent(self);
            tabs.setTitleAt(index, Messages.get(key));
            tabs.setToolTipTextAt(index, Messages.get(key + ".tip"));
        });
    }

    /**
     * Lets lists, tables and scroll panes ignore the keys that switch tabs, so that the tabbed pane around receives
     * them.
     */
    private static void leaveKeysToTabs(Component component) {
        if (component instanceof JScrollPane || component instanceof JTable || component instanceof JList) {
            for (String key : List.of("ctrl PAGE_UP", "ctrl PAGE_DOWN")) {
                KeyStroke stroke = KeyStroke.getKeyStroke(key);
                // A scroll pane with key bindings would get the focus by the Tab key.
                if (!(component instanceof JScrollPane)) {
                    ((JComponent) component)
                            .getInputMap(JComponent.WHEN_FOCUSED)
                            .put(stroke, "none");
                }
                ((JComponent) component)
                        .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                        .put(stroke, "none");
            }
        }
        if (component instanceof Container container) {
            Stream.of(container.getComponents()).forEach(UiText::leaveKeysToTabs);
        }
    }
}
