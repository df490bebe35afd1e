package faultline.gui.form;

import faultline.gui.theme.KeyBindings;
import faultline.gui.theme.UiText;
import faultline.io.XmlText;
import java.awt.Dimension;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.Optional;
import java.util.function.BiFunction;
import javax.swing.JTextField;

/**
 * A field whose text is applied by Enter, which then selects it, or when the focus leaves the field. If the text is not
 * allowed, a note below the field says why; the text stays until Escape is pressed or the focus leaves the field, which
 * shows the present value again.
 */
public abstract class EnteredTextField extends JTextField implements PendingField {

    private final transient RefusalNote note = new RefusalNote(this);

    /** The id of what is selected, which can be changed. */
    public static final class IdField extends EnteredTextField {

        private final transient BiFunction<String, String, Optional<String>> rename;
        /** Empty if nothing is selected. */
        private String id = "";

        /**
         * Creates a disabled field with the accessible name of a key, given what changes an id to another one and
         * returns why that is refused, empty if it is not.
         */
        public IdField(String key, int columns, BiFunction<String, String, Optional<String>> rename) {
            super(key, columns);
            this.rename = rename;
            setEnabled(false);
        }

        @Override
        protected String valueText() {
            return id;
        }

        @Override
        protected Optional<String> apply(String text) {
            String entered = XmlText.oneLine(text);
            Optional<String> refusal = rename.apply(id, entered);
            if (refusal.isEmpty()) {
                id = entered;
            }
            return refusal;
        }

        /** Selects another id, empty for none, after what is typed has been applied to the one before. */
        public void setId(String newId) {
            if (!newId.equals(id)) {
                commitPendingEdit();
                id = newId;
                showValue();
                setEnabled(!newId.isEmpty());
            }
        }
    }

    /** Creates an empty field with the accessible name of a key and the tool tip of {@code KEY.tip}. */
    protected EnteredTextField(String key, int columns) {
        super(columns);
        UiText.name(this, key);
        UiText.tip(this, key + ".tip");
        addActionListener(event -> {
            commitPendingEdit();
            if (!isEdited()) {
                selectAll();
            }
        });
        KeyBindings.bind(this, "ESCAPE", this::discardPendingEdit);
        KeyBindings.bind(this, "menu Z", this::isEdited, this::discardPendingEdit);
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                // As in a number field, the text stays while another window or a menu has the focus.
                if (!event.isTemporary()) {
                    commitOrRevert();
                }
            }
        });
    }

    /** Returns the text of the present value. */
    protected abstract String valueText();

    /** Applies a text that the user has entered; returns why it is not allowed, a sentence, empty if it is. */
    protected abstract Optional<String> apply(String text);

    /** Returns two thirds of the usual width, because the text scrolls in the field. */
    @Override
    public Dimension getMinimumSize() {
        Dimension usual = getPreferredSize();
        return new Dimension(usual.width * 2 / 3, usual.height);
    }

    @Override
    public boolean isEdited() {
        return !getText().equals(valueText());
    }

    /** Returns whether the text is that of the present value and is selected, as it is after Enter has applied it. */
    public boolean isApplied() {
        return !isEdited() && getText().equals(getSelectedText());
    }

    /** Shows the present value in place of what has been typed, from its beginning unless the field has the focus. */
    protected void showValue() {
        setText(valueText());
        if (!isFocusOwner()) {
            setCaretPosition(0);
        }
    }

    @Override
    public void discardPendingEdit() {
        showValue();
        note.hide();
    }

    @Override
    public boolean commitPendingEdit() {
        String before = valueText();
        if (commit()) {
            showValue();
        }
        return !valueText().equals(before);
    }

    /** Applies the text, or shows the present value if it is not allowed, as when the focus leaves the field. */
    public void commitOrRevert() {
        commit();
        showValue();
    }

    /** Applies the text; returns false if it is not allowed. */
    private boolean commit() {
        Optional<String> refusal = isEdited() ? apply(getText()) : Optional.empty();
        refusal.ifPresentOrElse(note::showBriefly, note::hide);
        return refusal.isEmpty();
    }
}
