package faultline.gui.form;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;

/** A layout that may be as narrow as its window and needs no names or state of its components. */
public abstract class StatelessLayout implements LayoutManager {

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension(0, preferredLayoutSize(parent).height);
    }

    @Override
    public void addLayoutComponent(String name, Component component) {
        // Components have no names.
    }

    @Override
    public void removeLayoutComponent(Component component) {
        // No state is kept.
    }
}
