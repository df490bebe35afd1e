package faultline.gui.form;

import faultline.gui.text.Messages;
import faultline.gui.theme.ScreenFit;
import faultline.io.MessageText;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.ComponentListener;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JOptionPane;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;

/** A form in a dialog that can be accepted or cancelled. */
public final class FormDialog {

    /** The room beside the text in the title bar of a dialog, pixels. */
    private static final int TITLE_MARGIN = 100;

    /** The greatest length of a line of a warning, in characters. */
    private static final int MAX_LINE_LENGTH = 80;

    /** The client property of a form that no entry can make acceptable: {@code Boolean.FALSE}. */
    private static final String ACCEPTABLE = "faultline.acceptable";

    private FormDialog() {}

    /**
     * What keeps a form from being accepted.
     *
     * @param sentence what is wrong; empty if the form itself shows it
     * @param field the component to correct, which gets the focus
     */
    public record FormProblem(String sentence, Component field) {
        /** Returns that the text of a field is missing or not allowed; the tool tip of the field says what is. */
        public static FormProblem ofText(JTextField field) {
            return ofText(field, field.getToolTipText());
        }

        /** Returns that the text of a field is missing or not allowed by a rule. */
        public static FormProblem ofText(JTextField field, String rule) {
            String text = field.getText().strip();
            return new FormProblem(
                    text.isEmpty()
                            ? Messages.get("number.missing", rule)
                            : Messages.get("number.invalid", MessageText.excerpt(text), rule),
                    field);
        }
    }

    /**
     * Shows a form, which scrolls if the screen is too small for it, waits for the answer, and returns whether the form
     * was accepted. The dialog grows with the form; {@code first} has the focus initially.
     */
    public static boolean showDialog(Component parent, String title, JComponent form, Component first) {
        return showDialog(parent, title, form, first, Optional::empty);
    }

    /**
     * Shows a form as {@link #showDialog(Component, String, JComponent, Component)} does. When the user accepts the
     * form, {@code check} returns what is wrong with it. As long as something is, the dialog stays and shows it.
     */
    public static boolean showDialog(
            Component parent, String title, JComponent form, Component first, Supplier<Optional<FormProblem>> check) {
        JOptionPane pane = new FormPane(title, form, first, check);
        NumberSpinner.findIn(form).forEach(NumberSpinner::passKeysOn);
        textFields(form).forEach(FocusSelection::install);
        JDialog dialog = pane.createDialog(parent, title);
        dialog.setResizable(true);
        ScreenFit.pack(dialog);
        ComponentListener growth = new Growth(dialog, form.getPreferredSize());
        form.addComponentListener(growth);
        dialog.setLocationRelativeTo(parent);
        dialog.setVisible(true);
        form.removeComponentListener(growth);
        dialog.dispose();
        return FormPane.ACCEPTED.equals(pane.getValue());
    }

    /** Enables or disables the button that accepts a form: no entry can mend some problems, such as a broken file. */
    public static void setAcceptable(JComponent form, boolean acceptable) {
        form.putClientProperty(ACCEPTABLE, acceptable);
    }

    /** Commits the visible numbers in a form; returns the first one that is not allowed, which its field shows. */
    public static Optional<FormProblem> findRefusedNumber(Container form) {
        return refusedNumbers(form).findFirst().map(field -> new FormProblem("", field.textField()));
    }

    /** Does the same as {@link #findRefusedNumber}, with a sentence about the field, which may be out of sight. */
    public static Optional<FormProblem> describeRefusedNumber(Container form) {
        return refusedNumbers(form).findFirst().map(field -> FormProblem.ofText(field.textField()));
    }

    private static Stream<NumberSpinner> refusedNumbers(Container form) {
        return NumberSpinner.findIn(form).filter(field -> field.isVisible() && !field.commitValidEdit());
    }

    /** Returns the fields for a text in a component and its descendants, without those that are a part of another. */
    private static Stream<JTextField> textFields(Container parent) {
        return Stream.of(parent.getComponents())
                .flatMap(child -> child instanceof JTextField field
                        ? Stream.of(field)
                        : child instanceof Container inner && !(child instanceof JSpinner || child instanceof JComboBox)
                                ? textFields(inner)
                                : Stream.empty());
    }

    /** Selects a text when its field gets the focus, as in a field for a number, unless the mouse places the caret. */
    private static final class FocusSelection extends FocusAdapter {

        private final JTextField field;
        /** Whether the mouse has placed the caret, or the field has the focus of a window that is not active. */
        private boolean keepsCaret;

        private FocusSelection(JTextField field) {
            this.field = field;
        }

        static void install(JTextField field) {
            FocusSelection selection = new FocusSelection(field);
            field.addFocusListener(selection);
            field.addMouseListener(new MouseAdapter() {
                @Override
                public void mousePressed(MouseEvent event) {
                    selection.keepsCaret = !field.isFocusOwner();
                }
            });
        }

        @Override
        public void focusGained(FocusEvent event) {
            if (!keepsCaret) {
                field.setCaretPosition(field.getDocument().getLength());
                // The caret is at the start, so that the start of a long text shows.
                field.moveCaretPosition(0);
            }
            keepsCaret = false;
        }

        @Override
        public void focusLost(FocusEvent event) {
            keepsCaret = event.isTemporary();
            if (!keepsCaret) {
                field.setCaretPosition(0);
            }
        }
    }

    /** Asks for a form; its dialog closes when the value is set. */
    private static final class FormPane extends JOptionPane {

        private static final Integer ACCEPTED = OK_OPTION;

        private final String title;
        private final JComponent form;
        private final Component first;
        private final transient Supplier<Optional<FormProblem>> check;

        FormPane(String title, JComponent form, Component first, Supplier<Optional<FormProblem>> check) {
            super(ScreenFit.scrolling(form), PLAIN_MESSAGE, OK_CANCEL_OPTION);
            this.title = title;
            this.form = form;
            this.first = first;
            this.check = check;
            form.addPropertyChangeListener(
                    ACCEPTABLE, event -> acceptButton(this).setEnabled(!Boolean.FALSE.equals(event.getNewValue())));
        }

        private static JButton acceptButton(Container pane) {
            return buttons(pane)
                    .filter(button ->
                            UIManager.getString("OptionPane.okButtonText").equals(button.getText()))
                    .findFirst()
                    .orElseThrow();
        }

        private static Stream<JButton> buttons(Container parent) {
            return Stream.of(parent.getComponents())
                    .flatMap(child -> child instanceof JButton button
                            ? Stream.of(button)
                            : child instanceof Container inner ? buttons(inner) : Stream.empty());
        }

        /** Returns a size with room for the title. */
        @Override
        public Dimension getPreferredSize() {
            Dimension size = super.getPreferredSize();
            int titleWidth = getFontMetrics(getFont()).stringWidth(title) + TITLE_MARGIN;
            return new Dimension(Math.max(size.width, titleWidth), size.height);
        }

        @Override
        public void selectInitialValue() {
            super.selectInitialValue();
            first.requestFocusInWindow();
        }

        @Override
        public void setValue(Object value) {
            Optional<FormProblem> problem = ACCEPTED.equals(value) ? check.get() : Optional.empty();
            problem.ifPresentOrElse(this::show, () -> super.setValue(value));
        }

        private void show(FormProblem problem) {
            if (!problem.sentence().isEmpty()) {
                showWarning(problem.sentence());
            }
            focus(SwingUtilities.getWindowAncestor(this), problem.field());
        }

        /** Gives a component the focus, which its window may get only later, when the warning is gone. */
        private static void focus(Window window, Component field) {
            if (window.isFocused()) {
                field.requestFocusInWindow();
            } else {
                window.addWindowFocusListener(new WindowAdapter() {
                    @Override
                    public void windowGainedFocus(WindowEvent event) {
                        window.removeWindowFocusListener(this);
                        field.requestFocusInWindow();
                    }
                });
            }
        }

        private void showWarning(String sentence) {
            JOptionPane pane = new JOptionPane(sentence, WARNING_MESSAGE) {
                @Override
                public int getMaxCharactersPerLineCount() {
                    return MAX_LINE_LENGTH;
                }
            };
            JDialog dialog = pane.createDialog(form, title);
            dialog.setVisible(true);
            dialog.dispose();
        }
    }

    /** Enlarges a dialog whose form needs more room than before, such as for a field that has become visible. */
    private static final class Growth extends ComponentAdapter {

        private final JDialog dialog;
        private Dimension needed;

        Growth(JDialog dialog, Dimension needed) {
            this.dialog = dialog;
            this.needed = needed;
        }

        @Override
        public void componentResized(ComponentEvent event) {
            Dimension before = needed;
            needed = event.getComponent().getPreferredSize();
            // A dialog that the user makes smaller stays so.
            if (needed.width > before.width || needed.height > before.height) {
                ScreenFit.resize(dialog, 1);
            }
        }
    }
}
