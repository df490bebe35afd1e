package faultline.gui.canvas;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** A value that tells its listeners whenever it changes. */
final class Watched<T> {

    private final List<Consumer<T>> listeners = new ArrayList<>();
    private T value;

    Watched(T value) {
        this.value = value;
    }

    T get() {
        return value;
    }

    void set(T newValue) {
        if (!newValue.equals(value)) {
            value = newValue;
            List.copyOf(listeners).forEach(listener -> listener.accept(newValue));
        }
    }

    void listen(Consumer<T> listener) {
        listeners.add(listener);
    }
}
