package faultline.gui.theme;

import faultline.gui.text.TextDirection;
import faultline.gui.text.TextWrap;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.KeyboardFocusManager;
import java.awt.RenderingHints;
import java.awt.Toolkit;
import java.awt.Window;
import java.beans.PropertyChangeListener;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.JToolTip;
import javax.swing.JViewport;
import javax.swing.KeyStroke;
import javax.swing.Popup;
import javax.swing.PopupFactory;
import javax.swing.SwingUtilities;
import javax.swing.UIDefaults;
import javax.swing.UIManager;
import javax.swing.UnsupportedLookAndFeelException;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.FontUIResource;
import javax.swing.plaf.basic.BasicGraphicsUtils;
import javax.swing.plaf.metal.MetalCheckBoxUI;
import javax.swing.plaf.metal.MetalLabelUI;
import javax.swing.plaf.metal.MetalLookAndFeel;
import javax.swing.plaf.metal.MetalToolTipUI;

/** Installs the flat look on top of Metal. */
final class FlatLook {

    /** The UI delegates. */
    private static final List<Class<?>> DELEGATES = List.of(
            FlatButtonUI.class,
            FlatScrollBarUI.class,
            FlatSliderUI.class,
            FlatSpinnerUI.class,
            FlatComboBoxUI.class,
            DialogButtons.FlatOptionPaneUI.class,
            FlatSplitPaneUI.class,
            FlatTabbedPaneUI.class,
            FlatMenuUI.class,
            FlatMenuItemUI.class,
            FlatLabelUI.class,
            FlatCheckBoxUI.class,
            FlatToolTipUI.class);

    /**
     * The border of a text field or of a scroll pane shows the focus, but Swing repaints only the caret or a cell when
     * the focus changes.
     */
    private static final PropertyChangeListener FOCUS_REPAINTER =
            change -> Stream.of(change.getOldValue(), change.getNewValue()).forEach(FlatLook::repaintBorder);

    private FlatLook() {}

    private static void repaintBorder(Object component) {
        if (component instanceof JTextField field) {
            field.repaint();
        } else if (component instanceof Component view && view.getParent() instanceof JViewport viewport) {
            viewport.getParent().repaint();
        }
    }

    static void install(Theme theme) {
        UIManager.put("swing.boldMetal", false);
        MetalLookAndFeel.setCurrentTheme(new FlatMetalTheme(theme.colours()));
        try {
            UIManager.setLookAndFeel(new MetalLookAndFeel());
        } catch (UnsupportedLookAndFeelException impossible) {
            throw new IllegalStateException("Metal is on every machine", impossible);
        }
        UIDefaults defaults = UIManager.getLookAndFeelDefaults();
        FontUIResource font = new FontUIResource(Font.SANS_SERIF, Font.PLAIN, TextSize.scaled(13));
        List.copyOf(defaults.keySet()).stream()
                .filter(key -> key.toString().matches(".*\\.(f|\\w+F)ont"))
                .forEach(key -> defaults.put(key, font));
        DELEGATES.forEach(delegate -> register(defaults, delegate));
        defaults.put("ToggleButtonUI", FlatButtonUI.class.getName());
        defaults.put("CheckBoxMenuItemUI", FlatMenuItemUI.class.getName());
        FlatDefaults.table(theme.colours()).forEach(defaults::put);
        enableTextAntialiasing(defaults);
        leaveGalleryKey(defaults);
        PopupFactory.setSharedInstance(new FlatPopupFactory());
        KeyboardFocusManager focus = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        focus.removePropertyChangeListener("focusOwner", FOCUS_REPAINTER);
        focus.addPropertyChangeListener("focusOwner", FOCUS_REPAINTER);
    }

    /**
     * Registers a delegate FlatXyzUI for XyzUI; the entry under the class name spares Swing a lookup by class loader.
     */
    private static void register(UIDefaults defaults, Class<?> delegate) {
        defaults.put(delegate.getSimpleName().substring("Flat".length()), delegate.getName());
        defaults.put(delegate.getName(), delegate);
    }

    /**
     * Makes a component show its text as it is, even if it looks like HTML: it may contain the name of a file or of an
     * obstacle. A component that shows HTML sets the property to false.
     */
    static void showPlainText(JComponent component) {
        if (component.getClientProperty("html.disable") == null) {
            component.putClientProperty("html.disable", true);
        }
    }

    /** Gives a menu or a list that is a window of its own its colour, which is visible before the first paint. */
    private static final class FlatPopupFactory extends PopupFactory {
        @Override
        public Popup getPopup(Component owner, Component contents, int x, int y) {
            Popup popup = super.getPopup(owner, contents, x, y);
            Window window = SwingUtilities.getWindowAncestor(contents);
            if (window != null && window.getType() == Window.Type.POPUP) {
                window.setBackground(contents.getBackground());
            }
            return popup;
        }
    }

    /** A label, also in lists, tables and option panes, that shows its text as it is, from left to right. */
    public static final class FlatLabelUI extends MetalLabelUI {

        private static final FlatLabelUI SHARED = new FlatLabelUI();

        /** Called by Swing to create a delegate. */
        public static ComponentUI createUI(JComponent component) {
            return SHARED;
        }

        @Override
        protected void installDefaults(JLabel label) {
            super.installDefaults(label);
            showPlainText(label);
        }

        @Override
        protected void paintEnabledText(JLabel label, Graphics graphics, String text, int x, int y) {
            super.paintEnabledText(label, graphics, TextDirection.leftToRight(text), x, y);
        }
    }

    /** A check box that shows its text as it is. */
    public static final class FlatCheckBoxUI extends MetalCheckBoxUI {

        /** Called by Swing to create a delegate. */
        public static ComponentUI createUI(JComponent component) {
            return new FlatCheckBoxUI();
        }

        @Override
        public void installDefaults(AbstractButton box) {
            super.installDefaults(box);
            showPlainText(box);
        }
    }

    /** A tool tip that shows its text as it is, in as many lines as necessary. */
    public static final class FlatToolTipUI extends MetalToolTipUI {

        /** The maximum width of a line, in widths of a digit. */
        private static final int MAX_DIGITS = 70;

        private static final double MAX_SHARE_OF_SCREEN = 0.7;

        /** Called by Swing to create a delegate. */
        public static ComponentUI createUI(JComponent component) {
            return new FlatToolTipUI();
        }

        @Override
        public void installUI(JComponent tip) {
            showPlainText(tip);
            super.installUI(tip);
        }

        @Override
        public Dimension getPreferredSize(JComponent tip) {
            List<String> lines = lines(tip);
            if (lines.size() < 2) {
                return super.getPreferredSize(tip);
            }
            FontMetrics metrics = tip.getFontMetrics(tip.getFont());
            Insets insets = tip.getInsets();
            int width = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
            return new Dimension(
                    insets.left + width + insets.right,
                    insets.top + lines.size() * metrics.getHeight() + insets.bottom);
        }

        @Override
        public void paint(Graphics graphics, JComponent tip) {
            List<String> lines = lines(tip);
            if (lines.size() < 2) {
                super.paint(graphics, tip);
                return;
            }
            FontMetrics metrics = tip.getFontMetrics(tip.getFont());
            Insets insets = tip.getInsets();
            graphics.setFont(tip.getFont());
            graphics.setColor(tip.getForeground());
            int y = insets.top + metrics.getAscent();
            for (String line : lines) {
                BasicGraphicsUtils.drawString(tip, (Graphics2D) graphics, line, insets.left, y);
                y += metrics.getHeight();
            }
        }

        private List<String> lines(JComponent tip) {
            String text = Objects.requireNonNullElse(((JToolTip) tip).getTipText(), "");
            String key = getAcceleratorString();
            FontMetrics metrics = tip.getFontMetrics(tip.getFont());
            int width = MAX_DIGITS * metrics.charWidth('0');
            if (!GraphicsEnvironment.isHeadless()) {
                int screen = tip.getToolkit().getScreenSize().width;
                width = Math.min(width, (int) (MAX_SHARE_OF_SCREEN * screen));
            }
            List<String> lines = TextWrap.lines(text, metrics, width);
            return lines.size() < 2 || key.isEmpty() ? lines : TextWrap.lines(text + "  " + key, metrics, width);
        }
    }

    /** Reserves Ctrl+Shift+O for the menu; Metal uses it to change the direction of a text. */
    private static void leaveGalleryKey(UIDefaults defaults) {
        for (String field : List.of("TextField", "FormattedTextField", "TextArea")) {
            if (defaults.get(field + ".focusInputMap") instanceof InputMap keys) {
                keys.remove(KeyStroke.getKeyStroke("control shift O"));
            }
        }
    }

    /** Enables text antialiasing if the desktop does not specify it. */
    private static void enableTextAntialiasing(UIDefaults defaults) {
        if (Toolkit.getDefaultToolkit().getDesktopProperty("awt.font.desktophints") == null) {
            defaults.put(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        }
    }
}
