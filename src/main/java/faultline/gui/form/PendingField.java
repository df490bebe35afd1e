package faultline.gui.form;

/** A field whose text is applied by Enter, or when the focus leaves the field. */
public interface PendingField {
    /** Applies the text now if it is allowed; returns whether that changed a value. */
    boolean commitPendingEdit();

    /** Shows the present value in place of what is being typed. */
    void discardPendingEdit();

    /** Returns whether the text is not that of the present value. */
    boolean isEdited();
}
