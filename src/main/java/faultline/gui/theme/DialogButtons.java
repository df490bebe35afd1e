package faultline.gui.theme;

import java.awt.Component;
import java.awt.Container;
import java.awt.FlowLayout;
import java.awt.event.ActionEvent;
import java.awt.event.FocusEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.AbstractAction;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.MenuSelectionManager;
import javax.swing.WindowConstants;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicOptionPaneUI;

/** The buttons and keys that dialogs have in common. */
public final class DialogButtons {

    private DialogButtons() {}

    /** Option panes whose buttons the left and right arrow keys move between. */
    public static final class FlatOptionPaneUI extends BasicOptionPaneUI {

        /** Called by Swing to create a delegate. */
        public static ComponentUI createUI(JComponent component) {
            return new FlatOptionPaneUI();
        }

        @Override
        protected Container createButtonArea() {
            Container row = super.createButtonArea();
            if (row instanceof JComponent buttons) {
                moveByArrows(buttons);
            }
            return row;
        }
    }

    /**
     * Runs an action when the user closes a dialog by its title bar or by Escape, unless that closes a menu. Nothing
     * else closes the dialog then.
     */
    public static void onClose(JDialog dialog, Runnable action) {
        dialog.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        dialog.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                action.run();
            }
        });
        dialog.getRootPane()
                .registerKeyboardAction(
                        event -> closeMenuOrRun(action),
                        KeyStroke.getKeyStroke("ESCAPE"),
                        JComponent.WHEN_IN_FOCUSED_WINDOW);
    }

    /** Closes the open menu, whose own key the dialog takes, or runs an action if there is none. */
    static void closeMenuOrRun(Runnable action) {
        MenuSelectionManager menus = MenuSelectionManager.defaultManager();
        if (menus.getSelectedPath().length > 0) {
            menus.clearSelectedPath();
        } else {
            action.run();
        }
    }

    /** Lets the left and right arrow keys move the focus between the buttons of a row, from the last to the first. */
    public static void moveByArrows(JComponent row) {
        bind(row, "LEFT", -1);
        bind(row, "RIGHT", 1);
    }

    private static void bind(JComponent row, String key, int step) {
        String name = "focus" + key;
        row.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(key), name);
        row.getActionMap().put(name, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                moveFocus(row, step);
            }
        });
    }

    private static void moveFocus(JComponent row, int step) {
        List<Component> buttons = Stream.of(row.getComponents())
                .filter(part -> part instanceof JButton && part.isShowing() && part.isEnabled())
                .toList();
        IntStream.range(0, buttons.size())
                .filter(i -> buttons.get(i).isFocusOwner())
                .forEach(i -> buttons.get(Math.floorMod(i + step, buttons.size()))
                        .requestFocusInWindow(
                                step > 0 ? FocusEvent.Cause.TRAVERSAL_FORWARD : FocusEvent.Cause.TRAVERSAL_BACKWARD));
    }

    /**
     * Returns a row with the only button of a dialog, given the key of its text. The title bar, Enter and Escape run
     * its action, too.
     */
    public static JPanel createSingleButton(JDialog dialog, String key, Runnable action) {
        JButton button = UiText.button(key);
        button.addActionListener(event -> action.run());
        dialog.getRootPane().setDefaultButton(button);
        onClose(dialog, action);
        JPanel row = new JPanel(new FlowLayout(FlowLayout.TRAILING, 0, 0));
        row.add(button);
        return row;
    }
}
