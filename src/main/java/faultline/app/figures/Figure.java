package faultline.app.figures;

import java.io.IOException;

/** One figure or study: knows how to make its files. */
interface Figure {

    /**
     * Makes the files.
     *
     * @param folder where they go
     * @throws IOException if one cannot be written
     */
    void make(FigureFolder folder) throws IOException;
}
