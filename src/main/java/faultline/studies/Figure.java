package faultline.studies;

import java.io.IOException;

/** One figure or study: knows how to make its files. */
interface Figure {

    /**
     * Makes the files.
     *
     * @param folder where they go
     * @throws IOException if one cannot be written
     */
    void write(FigureFolder folder) throws IOException;
}
