package faultline.gui.form;

import faultline.gui.text.Messages;
import faultline.gui.theme.KeyBindings;
import faultline.gui.theme.RefreshSteps;
import faultline.io.MessageText;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.math.BigDecimal;
import java.text.ParseException;
import java.util.function.DoubleConsumer;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JFormattedTextField;
import javax.swing.JSpinner;
import javax.swing.KeyStroke;
import javax.swing.SpinnerNumberModel;
import javax.swing.SwingConstants;
import javax.swing.text.DefaultFormatterFactory;

/**
 * A field for one number, which shows the present value unless the user is typing. It is as wide as its text needs. A
 * note below it says why a text is refused. It shows nothing for NaN.
 */
public final class NumberSpinner extends JSpinner implements PendingField {

    /** The width of the arrows and the margins, pixels. */
    private static final int PADDING = 32;

    private final transient DecimalFormatter formatter;
    private final SpinnerNumberModel model;
    /** The key of the name; empty for none. */
    private String nameKey = "";

    private String[] nameValues = {};
    /** The key of the tool tip; empty if it repeats the name. */
    private String tipKey = "";

    /** The width in digits, 0 for any. */
    private int columns;

    /** The width of the text in digits for which the field has been laid out. */
    private int shownDigits;

    private boolean updating;

    /**
     * Numbers with steps as of typed numbers: 0.1 and two steps of 0.1 give 0.3. A step beyond a limit gives the limit.
     */
    private static final class DecimalStepModel extends SpinnerNumberModel {
        DecimalStepModel(double value, double min, double max, double step) {
            super(value, min, max, step);
        }

        @Override
        public Object getNextValue() {
            double max = toDouble(getMaximum());
            return toDouble(getValue()) < max ? within(stepped(1), max) : null;
        }

        @Override
        public Object getPreviousValue() {
            double max = toDouble(getMaximum());
            return toDouble(getValue()) > toDouble(getMinimum()) ? within(stepped(-1), max) : null;
        }

        private double within(double number, double max) {
            return Math.max(toDouble(getMinimum()), Math.min(max, number));
        }

        private double stepped(int steps) {
            BigDecimal step = BigDecimal.valueOf(steps * toDouble(getStepSize()));
            return BigDecimal.valueOf(toDouble(getValue())).add(step).doubleValue();
        }

        private static double toDouble(Object number) {
            return ((Number) number).doubleValue();
        }
    }

    /** Null if another component says why a text is refused. */
    private transient RefusalNote note;

    /**
     * Creates a field.
     *
     * @param pattern the format, see {@link java.text.DecimalFormat}; without decimals, for whole numbers only
     * @param min the smallest value
     * @param max the largest value
     * @param step the step of the arrows
     * @param onChange receives every number that the user enters
     */
    public NumberSpinner(String pattern, double min, double max, double step, DoubleConsumer onChange) {
        formatter = new DecimalFormatter(pattern, min, max);
        model = new DecimalStepModel(Math.max(min, Math.min(max, 0)), min, max, step);
        setModel(model);
        JSpinner.DefaultEditor editor = new JSpinner.DefaultEditor(this);
        setEditor(editor);
        configureTextField(editor.getTextField());
        note = new RefusalNote(textField());
        RefreshSteps.add(this, NumberSpinner::refresh);
        addChangeListener(event -> {
            if (columns > 0 && textDigits() != shownDigits) {
                updateWidth();
            }
            if (!updating) {
                onChange.accept(doubleValue());
            }
        });
    }

    private void configureTextField(JFormattedTextField text) {
        text.setFormatterFactory(new DefaultFormatterFactory(formatter));
        text.setEditable(true);
        text.setHorizontalAlignment(SwingConstants.TRAILING);
        text.addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                // Not later, because keys that were typed meanwhile follow immediately.
                text.selectAll();
                updateNote();
            }

            @Override
            public void focusLost(FocusEvent event) {
                if (!event.isTemporary()) {
                    // The formatted text would stay selected.
                    text.setCaretPosition(0);
                }
                // The field reverts the text after this; a temporary loss of the focus does not.
                if (!event.isTemporary() && text.getFocusLostBehavior() == JFormattedTextField.COMMIT_OR_REVERT) {
                    noteRefusal();
                }
            }
        });
        KeyBindings.bind(text, "menu Z", this::isEdited, this::discardPendingEdit);
        // A space would replace the text if it is selected, and has no meaning in a number.
        text.getInputMap().put(KeyStroke.getKeyStroke(' '), "none");
        // As when the field gets the focus, so that the next number replaces this one.
        text.addActionListener(event -> text.selectAll());
        text.addPropertyChangeListener("editValid", event -> {
            // The outline of the spinner shows whether the text is valid.
            repaint();
            updateNote();
        });
    }

    /** Shows the limits while the text is not an allowed number. */
    private void updateNote() {
        JFormattedTextField text = textField();
        if (note != null && text.isFocusOwner()) {
            if (isRefused()) {
                note.show(Messages.get("faults.invalid", limitsText()));
            } else {
                note.hide();
            }
        }
    }

    private boolean isRefused() {
        return !textField().isEditValid() && !textField().getText().isBlank();
    }

    /** Says that the text is about to be replaced by the value before it. */
    private void noteRefusal() {
        if (note != null && isRefused()) {
            String sentence =
                    Messages.get("number.refused", typedText(), limitsText(), formatter.format(doubleValue()));
            EventQueue.invokeLater(
                    () -> note.showBriefly(textField().isShowing() ? sentence : name() + ": " + sentence));
        }
    }

    /** Lets the form show why a text is refused. */
    public NumberSpinner withoutNote() {
        note = null;
        return this;
    }

    /** Sets the accessible name to the text of a key with its placeholders, and shows the limits as a tool tip. */
    public NumberSpinner withName(String key, String... values) {
        nameKey = key;
        nameValues = values.clone();
        updateAccessibleText();
        return this;
    }

    private String name() {
        if (nameKey.isEmpty()) {
            return "";
        }
        return nameValues.length == 0 ? Messages.get(nameKey) : Messages.get(nameKey, nameValues);
    }

    private void updateAccessibleText() {
        String name = name();
        getAccessibleContext().setAccessibleName(name);
        textField().getAccessibleContext().setAccessibleName(name);
        String limits = formatter.limitsText();
        String tip = tipKey.isEmpty()
                ? name + ": " + limits
                : Messages.get(tipKey) + (model.getMinimum().equals(model.getMaximum()) ? "" : " (" + limits + ")");
        setToolTipText(tip);
        textField().setToolTipText(tip);
        nameArrows(name);
    }

    /** Shows the text of a key, and the limits unless they are equal, as the tool tip. */
    public void setTip(String key) {
        tipKey = key;
        updateAccessibleText();
    }

    /** Returns the fields in a component and its descendants. */
    public static Stream<NumberSpinner> findIn(Container parent) {
        return Stream.of(parent.getComponents())
                .flatMap(child -> child instanceof NumberSpinner field
                        ? Stream.of(field)
                        : child instanceof Container inner ? findIn(inner) : Stream.empty());
    }

    private void nameArrows(String name) {
        for (Component part : getComponents()) {
            if (part instanceof JButton arrow) {
                boolean up = "Spinner.nextButton".equals(arrow.getName());
                arrow.getAccessibleContext().setAccessibleName(Messages.get(up ? "spinner.up" : "spinner.down", name));
                // The JDK passes a tool tip on only when it changes, and another look has other arrows.
                arrow.setToolTipText(getToolTipText());
            }
        }
    }

    /** Sets other limits and a value within them, without notifying the listener. */
    public void setLimits(double min, double max, double value) {
        formatter.setLimits(min, max);
        quietly(() -> {
            model.setMinimum(min);
            model.setMaximum(max);
            setValue(value);
        });
        updateAccessibleText();
    }

    /**
     * Sets another upper limit, without notifying the listener; the value stays, even above it, and so does what the
     * user is typing.
     */
    public void setMax(double max) {
        if (!model.getMaximum().equals(max)) {
            formatter.setMax(max);
            if (isEdited()) {
                keepingText(() -> quietly(() -> model.setMaximum(max)));
            } else {
                quietly(() -> model.setMaximum(max));
            }
            updateAccessibleText();
        }
    }

    /** Makes a change after which the field would show its value. */
    private void keepingText(Runnable change) {
        JFormattedTextField field = textField();
        String typed = field.getText();
        int mark = field.getCaret().getMark();
        int dot = field.getCaret().getDot();
        change.run();
        field.setText(typed);
        field.setCaretPosition(mark);
        field.moveCaretPosition(dot);
    }

    /** Shows the present value, nothing for NaN, unless the user is typing; it may be outside the limits. */
    public void setWorldValue(double truth) {
        assert EventQueue.isDispatchThread();
        if (truth != doubleValue() && !isTyping()) {
            quietly(() -> setValue(truth));
        }
    }

    /** Commits the text, or reverts it if it is invalid, and returns whether the value changed. */
    @Override
    public boolean commitPendingEdit() {
        double before = doubleValue();
        try {
            commitEdit();
        } catch (ParseException notAllowed) {
            noteRefusal();
            textField().setValue(getValue());
        }
        return doubleValue() != before;
    }

    @Override
    public void discardPendingEdit() {
        textField().setValue(getValue());
        if (note != null) {
            note.hide();
        }
    }

    /** Leaves invalid text in the field when the focus moves on, so that the user sees the error. */
    public NumberSpinner keepInvalidText() {
        textField().setFocusLostBehavior(JFormattedTextField.COMMIT);
        return this;
    }

    /** Lets Enter press the default button of a dialog, which commits the text, and lets Escape close the dialog. */
    public void passKeysOn() {
        textField().getInputMap().put(KeyStroke.getKeyStroke("ENTER"), "none");
        textField().getInputMap().put(KeyStroke.getKeyStroke("ESCAPE"), "none");
    }

    /** Commits the text and returns true, or returns false if it is invalid; a field that does not apply has none. */
    public boolean commitValidEdit() {
        if (!isEnabled()) {
            return true;
        }
        try {
            commitEdit();
            return true;
        } catch (ParseException invalid) {
            return false;
        }
    }

    /** Returns what is typed, short enough for a sentence. */
    private String typedText() {
        return MessageText.excerpt(textField().getText().strip());
    }

    /** Returns a text that states the limits. */
    public String limitsText() {
        return formatter.limitsText();
    }

    /** Makes a change that is none by the user; a model notifies its listeners of other limits, too. */
    private void quietly(Runnable change) {
        updating = true;
        try {
            change.run();
        } finally {
            updating = false;
        }
    }

    private boolean isTyping() {
        return textField().isFocusOwner() && isEdited();
    }

    @Override
    public boolean isEdited() {
        return !textField().getText().equals(formatter.format(doubleValue()));
    }

    public double doubleValue() {
        return model.getNumber().doubleValue();
    }

    /** Returns the value of a field for whole numbers. */
    public long longValue() {
        return model.getNumber().longValue();
    }

    /** Returns the value of a field for whole numbers whose limits are those of an {@code int}, or narrower. */
    public int intValue() {
        return Math.toIntExact(longValue());
    }

    public JFormattedTextField textField() {
        return ((JSpinner.DefaultEditor) getEditor()).getTextField();
    }

    /** Sets the width in digits; where there is too little room, the field is one digit narrower. */
    public NumberSpinner withColumns(int digits) {
        columns = digits;
        textField().setColumns(0);
        updateWidth();
        return this;
    }

    private void updateWidth() {
        if (columns > 0) {
            setPreferredSize(null);
            shownDigits = textDigits();
            int digit = getFontMetrics(getFont()).stringWidth("0");
            int height = getPreferredSize().height;
            setPreferredSize(new Dimension(Math.max(columns, shownDigits) * digit + PADDING, height));
            setMinimumSize(new Dimension(Math.max(columns - 1, shownDigits) * digit + PADDING, height));
            revalidate();
        }
    }

    private int textDigits() {
        return formatter.format(doubleValue()).length();
    }

    private void refresh() {
        updateAccessibleText();
        updateWidth();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (nameKey != null && !nameKey.isEmpty()) {
            nameArrows(name());
        }
    }
}
