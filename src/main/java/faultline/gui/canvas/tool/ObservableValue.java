package faultline.gui.canvas.tool;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** A value that notifies its listeners when it changes. */
public final class ObservableValue<T> {

    private final List<Consumer<T>> listeners = new ArrayList<>();
    private T value;

    public ObservableValue(T value) {
        this.value = value;
    }

    public T get() {
        return value;
    }

    public void set(T newValue) {
        if (!newValue.equals(value)) {
            value = newValue;
            List.copyOf(listeners).forEach(listener -> listener.accept(newValue));
        }
    }

    public void addListener(Consumer<T> listener) {
        listeners.add(listener);
    }
}
