package faultline.gui.instrument;

import java.awt.Component;
import java.util.Optional;
import java.util.function.IntUnaryOperator;
import javax.swing.JSplitPane;

/** A split pane whose divider can be placed before the pane has a size: it goes to its place at the first layout. */
public final class PlacedSplit extends JSplitPane {

    private transient Optional<IntUnaryOperator> place = Optional.empty();

    /**
     * A split pane that lays out while its divider is dragged.
     *
     * @param orientation of {@link JSplitPane}
     * @param before left or above
     * @param after right or below
     * @param weight how much of the room that a larger pane has goes before the divider, in [0, 1]
     */
    public PlacedSplit(int orientation, Component before, Component after, double weight) {
        super(orientation, before, after);
        setResizeWeight(weight);
        setContinuousLayout(true);
    }

    /**
     * Places the divider.
     *
     * @param location its place for a size of the pane less the divider's, pixels; asked once
     */
    public void place(IntUnaryOperator location) {
        place = Optional.of(location);
        placeIfSized();
        revalidate();
    }

    private void placeIfSized() {
        int size = (getOrientation() == VERTICAL_SPLIT ? getHeight() : getWidth()) - getDividerSize();
        if (place.isPresent() && size > 0) {
            setDividerLocation(place.get().applyAsInt(size));
            place = Optional.empty();
        }
    }

    @Override
    public void doLayout() {
        placeIfSized();
        super.doLayout();
    }
}
