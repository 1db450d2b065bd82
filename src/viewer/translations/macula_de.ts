<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Clip</name>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>superior</translation>
    </message>
</context>
<context>
    <name>Fidelity</name>
    <message>
        <source>, fovea traced %L1 s ago</source>
        <translation>, Fovea vor %L1 s verfolgt</translation>
    </message>
    <message>
        <source>Peripheral model, %L1 splats, %L2 steps</source>
        <translation>Peripheres Modell, %L1 Splats, %L2 Schritte</translation>
    </message>
    <message>
        <source>, values on cut faces only coarsely</source>
        <translation>, Werte auf Schnittflächen nur grob</translation>
    </message>
    <message>
        <source>, preview</source>
        <translation>, Vorschau</translation>
    </message>
    <message>
        <source>, denoised</source>
        <translation>, entrauscht</translation>
    </message>
    <message>
        <source>, smoothed</source>
        <translation>, geglättet</translation>
    </message>
    <message>
        <source>, 1/%1 of the pixels each way</source>
        <translation>, 1/%1 der Pixel je Richtung</translation>
    </message>
    <message>
        <source>, %1 samples</source>
        <translation>, %1 Abtastungen</translation>
    </message>
    <message>
        <source>, %1 of %2 samples</source>
        <translation>, %1 von %2 Abtastungen</translation>
    </message>
    <message>
        <source>, complete</source>
        <translation>, vollständig</translation>
    </message>
    <message>
        <source>, converging</source>
        <translation>, wird besser</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Keys and Mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>About Macula</source>
        <translation>Über Macula</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Macula %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Path-traced anatomy from DICOM.&lt;/p&gt;&lt;p&gt;Not a medical device, and &lt;b&gt;not for primary diagnosis&lt;/b&gt;.&lt;/p&gt;&lt;p&gt;Licence: Apache-2.0.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Macula %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Pfadverfolgte Anatomie aus DICOM.&lt;/p&gt;&lt;p&gt;Kein Medizinprodukt und &lt;b&gt;nicht zur Primärdiagnose&lt;/b&gt;.&lt;/p&gt;&lt;p&gt;Lizenz: Apache-2.0.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>JoinQuestion</name>
    <message>
        <source>One series?</source>
        <translation>Eine Serie?</translation>
    </message>
    <message>
        <source> Are they one series?</source>
        <translation> Sind sie eine Serie?</translation>
    </message>
    <message>
        <source>If you join them, check that all of them are of one patient and one examination.</source>
        <translation>Wenn Sie sie verbinden, prüfen Sie, dass alle von einem Patienten und einer Untersuchung sind.</translation>
    </message>
    <message>
        <source>&amp;Join Them</source>
        <translation>&amp;Verbinden</translation>
    </message>
</context>
<context>
    <name>KeyBook</name>
    <message>
        <source>Only one key at a time can be taken, with Ctrl, Shift or Alt.</source>
        <translation>Es kann nur eine Taste auf einmal sein, mit Strg, Umschalt oder Alt.</translation>
    </message>
    <message>
        <source>%1 is used in panes, lists and fields. Take another key.</source>
        <translation>%1 wird in Bildfeldern, Listen und Feldern gebraucht. Nehmen Sie eine andere Taste.</translation>
    </message>
    <message>
        <source>This works in the picture, with one key alone. Take one without Ctrl, Shift or Alt.</source>
        <translation>Das wirkt im Bild mit einer Taste allein. Nehmen Sie eine ohne Strg, Umschalt oder Alt.</translation>
    </message>
    <message>
        <source>%1 is the key of “%2”. Change that one first, or take another key.</source>
        <translation>%1 ist die Taste von „%2“. Ändern Sie zuerst diese, oder nehmen Sie eine andere Taste.</translation>
    </message>
</context>
<context>
    <name>Look</name>
    <message>
        <source>Path traced</source>
        <translation>Pfadverfolgt</translation>
    </message>
    <message>
        <source>Path traced, clear</source>
        <translation>Pfadverfolgt, klar</translation>
    </message>
</context>
<context>
    <name>Model</name>
    <message>
        <source>Finding points of the peripheral model</source>
        <translation>Punkte des peripheren Modells werden gesucht</translation>
    </message>
    <message>
        <source>Model of an earlier session, %1 steps</source>
        <translation>Modell einer früheren Sitzung, %1 Schritte</translation>
    </message>
    <message>
        <source>Model learning, %1 steps</source>
        <translation>Modell lernt, %1 Schritte</translation>
    </message>
    <message>
        <source>Model complete, %1 steps</source>
        <translation>Modell fertig, %1 Schritte</translation>
    </message>
    <message>
        <source>No memory for a model</source>
        <translation>Kein Speicher für ein Modell</translation>
    </message>
    <message>
        <source>No model</source>
        <translation>Kein Modell</translation>
    </message>
    <message>
        <source>It goes on from where an earlier session left it.</source>
        <translation>Es macht weiter, wo eine frühere Sitzung aufgehört hat.</translation>
    </message>
    <message>
        <source>It began with the stored model of other lights.</source>
        <translation>Es hat mit dem gespeicherten Modell einer anderen Beleuchtung begonnen.</translation>
    </message>
    <message>
        <source>It began with a model that another version of Macula stored.</source>
        <translation>Es hat mit einem Modell begonnen, das eine andere Version von Macula gespeichert hat.</translation>
    </message>
    <message>
        <source>The stored model of this was damaged; it began anew.</source>
        <translation>Das gespeicherte Modell hiervon war beschädigt; es hat neu begonnen.</translation>
    </message>
    <message>
        <source>The graphics device has no room for it beside the volume: while a hand moves, small traced pictures are shown.</source>
        <translation>Das Grafikgerät hat neben dem Volumen keinen Platz dafür: während der Bewegung werden kleine verfolgte Bilder gezeigt.</translation>
    </message>
    <message>
        <source>It could not be made on this graphics device: while a hand moves, small traced pictures are shown.</source>
        <translation>Es konnte auf diesem Grafikgerät nicht erstellt werden: während der Bewegung werden kleine verfolgte Bilder gezeigt.</translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>The preset %1 is made for values in %2; those of this volume are %3. What it shows here, and in which colours, means nothing.</source>
        <translation>Die Voreinstellung %1 ist für Werte in %2 gemacht; die dieses Volumens sind %3. Was sie hier zeigt und in welchen Farben, bedeutet nichts.</translation>
    </message>
    <message>
        <source>another unit</source>
        <translation>einer anderen Einheit</translation>
    </message>
    <message>
        <source>raw numbers of the scanner</source>
        <translation>rohe Zahlen des Geräts</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>The preset %1 is made for %2; this volume is %3. Its colours may mean something else here.</source>
        <translation>Die Voreinstellung %1 ist für %2 gemacht; dieses Volumen ist %3. Ihre Farben können hier etwas anderes bedeuten.</translation>
    </message>
</context>
<context>
    <name>QDialog</name>
    <message>
        <source>%1 in pixels, 1 to %2</source>
        <translation>%1 in Pixeln, 1 bis %2</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>The side of the patient at the %1 of the picture: Anterior, Posterior, Left, Right, Superior, Inferior</source>
        <translation>Die Seite des Patienten %1 im Bild: anterior (A), posterior (P), links (L), rechts (R), superior (S), inferior (I)</translation>
    </message>
</context>
<context>
    <name>SliceTool</name>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>All panes go to the point that is clicked or dragged to</source>
        <translation>Alle Bildfelder gehen zu dem Punkt, der angeklickt oder auf den gezogen wird</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Drag: wider to the right, brighter up</source>
        <translation>Ziehen: nach rechts breiter, nach oben heller</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Drag: closer up, farther down</source>
        <translation>Ziehen: nach oben näher, nach unten weiter weg</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Drag the picture sideways</source>
        <translation>Das Bild seitwärts ziehen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Measure from point to point, in mm</source>
        <translation>Von Punkt zu Punkt messen, in mm</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Measure between two legs, in degrees</source>
        <translation>Zwischen zwei Schenkeln messen, in Grad</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Measure area, in mm², and values within it</source>
        <translation>Fläche in mm² und Werte darin messen</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>Read the value of the voxel that is pointed at, in its unit</source>
        <translation>Den Wert des Voxels unter dem Zeiger ablesen, in seiner Einheit</translation>
    </message>
</context>
<context>
    <name>Slices</name>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>%1, oblique</source>
        <translation>%1, schräg</translation>
    </message>
    <message>
        <source>%1 %2 %3 mm</source>
        <translation>%1 %2 %3 mm</translation>
    </message>
    <message>
        <source>%1, slice %2 of %3</source>
        <translation>%1, Schicht %2 von %3</translation>
    </message>
    <message>
        <source>MIP %1 mm</source>
        <translation>MIP %1 mm</translation>
    </message>
    <message>
        <source>MinIP %1 mm</source>
        <translation>MinIP %1 mm</translation>
    </message>
    <message>
        <source>Mean %1 mm</source>
        <translation>Mittelwert %1 mm</translation>
    </message>
    <message>
        <source>Outside, %1</source>
        <translation>Außerhalb, %1</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Füllwert</translation>
    </message>
    <message>
        <source>%1 at (%2, %3, %4), %5</source>
        <translation>%1 bei (%2, %3, %4), %5</translation>
    </message>
</context>
<context>
    <name>Visibility</name>
    <message>
        <source>its values are %1 to %2 %3</source>
        <translation>seine Werte sind %1 bis %2 %3</translation>
    </message>
    <message>
        <source>All of this volume is %1 in the window %2: %3.</source>
        <translation>Dieses Volumen ist in der Fensterung %2 ganz %1: %3.</translation>
    </message>
    <message>
        <source>black</source>
        <translation>schwarz</translation>
    </message>
    <message>
        <source>white</source>
        <translation>weiß</translation>
    </message>
    <message>
        <source>This volume has no values: all of it is padding.</source>
        <translation>Dieses Volumen hat keine Werte: es besteht nur aus Füllwerten.</translation>
    </message>
    <message>
        <source>Nothing of this volume can be seen with the preset %1: %2.</source>
        <translation>Mit der Voreinstellung %1 ist von diesem Volumen nichts zu sehen: %2.</translation>
    </message>
    <message>
        <source> Presets that show something of it: %1.</source>
        <translation> Voreinstellungen, die etwas davon zeigen: %1.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ClipPanel</name>
    <message>
        <source>Turn inside out</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Shows what the clip removes, and removes what it shows</source>
        <translation>Zeigt, was der Beschnitt entfernt, und entfernt, was er zeigt</translation>
    </message>
    <message>
        <source>Undo all: no clip</source>
        <translation>Alles zurück: kein Beschnitt</translation>
    </message>
    <message>
        <source>Shows all of the volume again</source>
        <translation>Zeigt wieder das ganze Volumen</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>No clip</source>
        <translation>Kein Beschnitt</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigener</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Cut at the cross-hair</source>
        <translation>Am Fadenkreuz abschneiden</translation>
    </message>
    <message>
        <source>Where the cross-hair is, in mm of the patient (LPS)</source>
        <translation>Wo das Fadenkreuz ist, in mm des Patienten (LPS)</translation>
    </message>
    <message>
        <source>Removes everything %1 of the cross-hair</source>
        <translation>Entfernt alles, was vom Fadenkreuz aus %1 liegt</translation>
    </message>
    <message>
        <source>At the cross-hair</source>
        <translation>Am Fadenkreuz</translation>
    </message>
    <message>
        <source>Thickness of the slab</source>
        <translation>Dicke des Slabs</translation>
    </message>
    <message>
        <source>How thick the slab is, in mm</source>
        <translation>Wie dick der Slab ist, in mm</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Direction of the slab</source>
        <translation>Richtung des Slabs</translation>
    </message>
    <message>
        <source>Along which slices the slab lies</source>
        <translation>Entlang welcher Schichten der Slab liegt</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Which of the eight parts around the cross-hair is meant</source>
        <translation>Welcher der acht Teile um das Fadenkreuz gemeint ist</translation>
    </message>
    <message>
        <source>Radius of the ball</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source>From its centre, in mm</source>
        <translation>Von der Mitte aus, in mm</translation>
    </message>
    <message>
        <source>Keep a slab</source>
        <translation>Slab behalten</translation>
    </message>
    <message>
        <source>Keeps a slab with the cross-hair in its middle</source>
        <translation>Behält einen Slab mit dem Fadenkreuz in der Mitte</translation>
    </message>
    <message>
        <source>Remove a ball</source>
        <translation>Kugel entfernen</translation>
    </message>
    <message>
        <source>Removes a ball around the cross-hair; it takes the place of another ball</source>
        <translation>Entfernt eine Kugel um das Fadenkreuz; sie ersetzt eine andere Kugel</translation>
    </message>
    <message>
        <source>Take it out</source>
        <translation>Herausnehmen</translation>
    </message>
    <message>
        <source>Removes that corner; it takes the place of another corner</source>
        <translation>Entfernt diese Ecke; sie ersetzt eine andere Ecke</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Slab</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Which part of the volume is shown</source>
        <translation>Welcher Teil des Volumens gezeigt wird</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>A box is removed.</source>
        <translation>Ein Quader ist entfernt.</translation>
    </message>
    <message>
        <source>Only a turned box is kept.</source>
        <translation>Nur ein gedrehter Quader bleibt.</translation>
    </message>
    <message>
        <source>Oblique planes that cut: %1.</source>
        <translation>Schräge Ebenen, die schneiden: %1.</translation>
    </message>
    <message>
        <source>A corner is removed.</source>
        <translation>Eine Ecke ist entfernt.</translation>
    </message>
    <message>
        <source>A ball is removed.</source>
        <translation>Eine Kugel ist entfernt.</translation>
    </message>
    <message>
        <source>Only a ball is kept.</source>
        <translation>Nur eine Kugel bleibt.</translation>
    </message>
    <message>
        <source>%1, %2, %3 mm</source>
        <translation>%1, %2, %3 mm</translation>
    </message>
    <message>
        <source>All of the volume is shown.</source>
        <translation>Das ganze Volumen wird gezeigt.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::FaceRow</name>
    <message>
        <source>Clip face, %1, slider</source>
        <translation>Schnittfläche %1, Schieber</translation>
    </message>
    <message>
        <source>Clip face, %1, in mm</source>
        <translation>Schnittfläche %1, in mm</translation>
    </message>
    <message>
        <source>Open the clip face, %1</source>
        <translation>Schnittfläche %1 öffnen</translation>
    </message>
    <message>
        <source>Where the %1 face of what is shown is, in mm of the patient (LPS)</source>
        <translation>Wo die Fläche %1 des Gezeigten ist, in mm des Patienten (LPS)</translation>
    </message>
    <message>
        <source>Show all of the volume on the %1 side again</source>
        <translation>Auf der Seite %1 wieder das ganze Volumen zeigen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::FidelityBadge</name>
    <message>
        <source>Final</source>
        <translation>Endgültig</translation>
    </message>
    <message>
        <source>Preliminary</source>
        <translation>Vorläufig</translation>
    </message>
    <message>
        <source>Nothing will change any more</source>
        <translation>Es ändert sich nichts mehr</translation>
    </message>
    <message>
        <source>The picture gets better</source>
        <translation>Das Bild wird noch besser</translation>
    </message>
</context>
<context>
    <name>macula::viewer::KeysPage</name>
    <message>
        <source>&amp;No Key</source>
        <translation>&amp;Keine Taste</translation>
    </message>
    <message>
        <source>&amp;Usual Key</source>
        <translation>&amp;Übliche Taste</translation>
    </message>
    <message>
        <source>&amp;All as Usual</source>
        <translation>&amp;Alle wie üblich</translation>
    </message>
    <message>
        <source>Search the actions and keys</source>
        <translation>Befehle und Tasten durchsuchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Words of an action, or a key such as F3</source>
        <translation>Wörter eines Befehls oder eine Taste wie F3</translation>
    </message>
    <message>
        <source>New key of the selected action</source>
        <translation>Neue Taste des gewählten Befehls</translation>
    </message>
    <message>
        <source>Press the new key of the selected action, with Ctrl, Shift or Alt where wanted</source>
        <translation>Drücken Sie die neue Taste des gewählten Befehls, bei Bedarf mit Strg, Umschalt oder Alt</translation>
    </message>
    <message>
        <source>The selected action has no key</source>
        <translation>Der gewählte Befehl hat keine Taste</translation>
    </message>
    <message>
        <source>The selected action has the key again that it came with</source>
        <translation>Der gewählte Befehl hat wieder die mitgelieferte Taste</translation>
    </message>
    <message>
        <source>All actions have the keys again that they came with</source>
        <translation>Alle Befehle haben wieder die mitgelieferten Tasten</translation>
    </message>
    <message>
        <source>What the mouse does, and arrows, digits and letters on slices, is fixed: F1 shows it.</source>
        <translation>Was die Maus tut, und Pfeile, Ziffern und Buchstaben auf Schichten, steht fest: F1 zeigt es.</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>What the window can do, and the key for it; those you have changed are bold</source>
        <translation>Was das Fenster kann und die Taste dafür; fett ist, was Sie geändert haben</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MainWindow</name>
    <message>
        <source>Opening</source>
        <translation>Wird geöffnet</translation>
    </message>
    <message>
        <source>Looking for the table</source>
        <translation>Der Tisch wird gesucht</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Where the light comes from</source>
        <translation>Woher das Licht kommt</translation>
    </message>
    <message>
        <source>Only Cinematic and Clear have lights</source>
        <translation>Nur Cinematic und Klar haben eine Beleuchtung</translation>
    </message>
    <message>
        <source>In this look a preset that is chosen gives the window only</source>
        <translation>In dieser Darstellung gibt eine gewählte Voreinstellung nur die Fensterung vor</translation>
    </message>
    <message>
        <source>What is seen, and in which colours</source>
        <translation>Was zu sehen ist und in welchen Farben</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files</source>
        <translation>Ordner mit DICOM-Dateien öffnen</translation>
    </message>
    <message>
        <source>Open an image or a volume</source>
        <translation>Bild oder Volumen öffnen</translation>
    </message>
    <message>
        <source>Only one folder or file can be opened at a time.</source>
        <translation>Es kann nur ein Ordner oder eine Datei auf einmal geöffnet werden.</translation>
    </message>
    <message>
        <source>Drop one of them, or the folder that holds them all.</source>
        <translation>Legen Sie einen davon ab, oder den Ordner, in dem alle sind.</translation>
    </message>
    <message>
        <source> What is on screen is still of the study that was open before.</source>
        <translation> Auf dem Bildschirm ist noch die Studie, die vorher offen war.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>The preset %1 is not made for this kind of volume; %2 is used instead.</source>
        <translation>Die Voreinstellung %1 ist nicht für solche Volumen gemacht; stattdessen wird %2 verwendet.</translation>
    </message>
    <message>
        <source>This study is shown as it was left. The View menu shows it as when first opened.</source>
        <translation>Diese Studie wird gezeigt, wie sie verlassen wurde. Das Menü Ansicht zeigt sie wie beim ersten Öffnen.</translation>
    </message>
    <message>
        <source>No study is open</source>
        <translation>Keine Studie ist offen</translation>
    </message>
    <message>
        <source>Starting the graphics device again…</source>
        <translation>Das Grafikgerät wird neu gestartet…</translation>
    </message>
    <message>
        <source>The graphics device stopped responding and is started again; the picture is made anew. If this comes back, update the graphics driver.</source>
        <translation>Das Grafikgerät hat nicht mehr geantwortet und wird neu gestartet; das Bild wird neu erstellt. Wenn das wieder vorkommt, aktualisieren Sie den Grafiktreiber.</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>, %1 samples left out</source>
        <translation>, %1 Abtastungen ausgelassen</translation>
    </message>
    <message>
        <source>, less than the full resolution</source>
        <translation>, weniger als die volle Auflösung</translation>
    </message>
    <message>
        <source>The graphics device stopped responding and was started again. If this comes back, update the graphics driver.</source>
        <translation>Das Grafikgerät hat nicht mehr geantwortet und wurde neu gestartet. Wenn das wieder vorkommt, aktualisieren Sie den Grafiktreiber.</translation>
    </message>
    <message>
        <source>, %1/s</source>
        <translation>, %1/s</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>&amp;About Macula</source>
        <translation>&amp;Über Macula</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open Folder…</source>
        <translation>&amp;Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open the best volume in a folder of DICOM files</source>
        <translation>Das beste Volumen eines Ordners mit DICOM-Dateien öffnen</translation>
    </message>
    <message>
        <source>Open &amp;File…</source>
        <translation>&amp;Datei öffnen…</translation>
    </message>
    <message>
        <source>Open the series of an image, a DICOMDIR, or a NIfTI, NRRD or MetaImage file</source>
        <translation>Die Serie eines Bildes, ein DICOMDIR oder eine NIfTI-, NRRD- oder MetaImage-Datei öffnen</translation>
    </message>
    <message>
        <source>Open &amp;Phantom</source>
        <translation>&amp;Phantom öffnen</translation>
    </message>
    <message>
        <source>Open the built-in phantom study</source>
        <translation>Die eingebaute Phantomstudie öffnen</translation>
    </message>
    <message>
        <source>Open &amp;View…</source>
        <translation>&amp;Ansicht öffnen…</translation>
    </message>
    <message>
        <source>Show this study as it was when a view was saved</source>
        <translation>Diese Studie so zeigen, wie sie beim Speichern einer Ansicht war</translation>
    </message>
    <message>
        <source>&amp;Save View…</source>
        <translation>Ansicht &amp;speichern…</translation>
    </message>
    <message>
        <source>All that was chosen, and the camera, for another time</source>
        <translation>Alles, was gewählt wurde, und die Kamera, für ein andermal</translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation>&amp;Bild speichern…</translation>
    </message>
    <message>
        <source>Draw what is seen in 3D at any size and quality, without names</source>
        <translation>Zeichnet, was in 3D zu sehen ist, in jeder Größe und Qualität, ohne Namen</translation>
    </message>
    <message>
        <source>Save &amp;Measurements…</source>
        <translation>&amp;Messungen speichern…</translation>
    </message>
    <message>
        <source>As a table (CSV) or JSON, in mm, degrees and the unit of the study</source>
        <translation>Als Tabelle (CSV) oder JSON, in mm, Grad und der Einheit der Studie</translation>
    </message>
    <message>
        <source>Save P&amp;reset…</source>
        <translation>&amp;Voreinstellung speichern…</translation>
    </message>
    <message>
        <source>The transfer function, for other studies and programs</source>
        <translation>Die Übertragungsfunktion, für andere Studien und Programme</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Be&amp;enden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Find a Study…</source>
        <translation>Studie &amp;suchen…</translation>
    </message>
    <message>
        <source>Remove All &amp;Measurements</source>
        <translation>Alle &amp;Messungen entfernen</translation>
    </message>
    <message>
        <source>Remove measurements</source>
        <translation>Messungen entfernen</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Language, look, keys, and what is kept</source>
        <translation>Sprache, Aussehen, Tasten und was aufbewahrt wird</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Fit what is visible</source>
        <translation>Sichtbares einpassen</translation>
    </message>
    <message>
        <source>Show as when first opened</source>
        <translation>Wie beim ersten Öffnen zeigen</translation>
    </message>
    <message>
        <source>Preset, lights, clip, look and camera that a study has which nobody has seen yet</source>
        <translation>Voreinstellung, Beleuchtung, Beschnitt, Darstellung und Kamera einer Studie, die noch niemand gesehen hat</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Bildfelder</translation>
    </message>
    <message>
        <source>Patient and study over the picture</source>
        <translation>Patient und Studie über dem Bild</translation>
    </message>
    <message>
        <source>Trace where the pointer is, while moving</source>
        <translation>Bei Bewegung dort verfolgen, wo der Zeiger ist</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>Dar&amp;stellung</translation>
    </message>
    <message>
        <source>&amp;Shade Ray Cast</source>
        <translation>Volumen-Rendering &amp;schattieren</translation>
    </message>
    <message>
        <source>Light ray casts from the eye, as much as the preset says</source>
        <translation>Volumen-Rendering vom Auge aus beleuchten, so viel die Voreinstellung vorgibt</translation>
    </message>
    <message>
        <source>Reset &amp;Window</source>
        <translation>&amp;Fensterung zurücksetzen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Of the values: that of the series</source>
        <translation>Der Werte: die der Serie</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>&amp;Clip</source>
        <translation>Besch&amp;nitt</translation>
    </message>
    <message>
        <source>&amp;No Clip</source>
        <translation>&amp;Kein Beschnitt</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source> Preset </source>
        <translation> Voreinstellung </translation>
    </message>
    <message>
        <source>  Lights </source>
        <translation>  Beleuchtung </translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>How true the picture is</source>
        <translation>Wie getreu das Bild ist</translation>
    </message>
    <message>
        <source>The peripheral model: splats that are shown with all pixels while a hand moves</source>
        <translation>Das periphere Modell: Splats, die während der Bewegung mit allen Pixeln gezeigt werden</translation>
    </message>
    <message>
        <source>Pixels, pictures per second</source>
        <translation>Pixel, Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Voxels and their size</source>
        <translation>Voxel und ihre Größe</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Das Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>The picture is written to %1.</source>
        <translation>Das Bild ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source>There is no picture to save yet.</source>
        <translation>Es gibt noch kein Bild zu speichern.</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png);;Linear light and depth (*.exr);;DICOM Secondary Capture (*.dcm)</source>
        <translation>Bilder (*.png);;Lineares Licht und Tiefe (*.exr);;DICOM Secondary Capture (*.dcm)</translation>
    </message>
    <message>
        <source>There is no preset to save yet.</source>
        <translation>Es gibt noch keine Voreinstellung zu speichern.</translation>
    </message>
    <message>
        <source>Save the preset</source>
        <translation>Voreinstellung speichern</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Voreinstellungen (*.json)</translation>
    </message>
    <message>
        <source>The preset is written to %1. Open it with --preset %1.</source>
        <translation>Die Voreinstellung ist in %1 gespeichert. Öffnen Sie sie mit --preset %1.</translation>
    </message>
    <message>
        <source>There are no measurements to save.</source>
        <translation>Es gibt keine Messungen zu speichern.</translation>
    </message>
    <message>
        <source>Measure something on a slice first.</source>
        <translation>Messen Sie zuerst etwas auf einer Schicht.</translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation>Messungen speichern</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json)</source>
        <translation>Tabelle (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>The measurements are written to %1.</source>
        <translation>Die Messungen sind in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Transfer Function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
    <message>
        <source>How this study was left cannot be read; it is shown as when opened first.</source>
        <translation>Wie diese Studie verlassen wurde, kann nicht gelesen werden; sie wird wie beim ersten Öffnen gezeigt.</translation>
    </message>
    <message>
        <source>Show afresh</source>
        <translation>Neu zeigen</translation>
    </message>
    <message>
        <source>The settings are saved. Language and sessions follow them from the next start.</source>
        <translation>Die Einstellungen sind gespeichert. Sprache und Sitzungen folgen ihnen ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>Open view</source>
        <translation>Ansicht öffnen</translation>
    </message>
    <message>
        <source>Open a view</source>
        <translation>Ansicht öffnen</translation>
    </message>
    <message>
        <source>Views (*.json)</source>
        <translation>Ansichten (*.json)</translation>
    </message>
    <message>
        <source>There is no view to save yet.</source>
        <translation>Es gibt noch keine Ansicht zu speichern.</translation>
    </message>
    <message>
        <source>Save the view</source>
        <translation>Ansicht speichern</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MessageBar</name>
    <message>
        <source>Dismiss this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PatientMmBox</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PictureDialog</name>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>&amp;Without patient and study</source>
        <translation>&amp;Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>As on screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Twice the screen</source>
        <translation>Zweimal der Bildschirm</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>Full HD</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>Andere Größe</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>More samples per pixel: less noise, and more time</source>
        <translation>Mehr Abtastungen je Pixel: weniger Rauschen und mehr Zeit</translation>
    </message>
    <message>
        <source>1 sample</source>
        <translation>1 Abtastung</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Abtastungen</translation>
    </message>
    <message>
        <source>Of DICOM files: nothing of the patient is written, and all UIDs are new. Other files never name anybody. A face can still be seen.</source>
        <translation>Bei DICOM-Dateien: vom Patienten wird nichts geschrieben, und alle UIDs sind neu. Andere Dateien nennen nie jemanden. Ein Gesicht ist trotzdem zu erkennen.</translation>
    </message>
    <message>
        <source>&amp;Choose File…</source>
        <translation>&amp;Datei wählen…</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>A usual size in pixels; any other below</source>
        <translation>Eine übliche Größe in Pixeln; jede andere darunter</translation>
    </message>
    <message>
        <source>Choose where the picture is saved; then it is drawn</source>
        <translation>Wählen, wo das Bild gespeichert wird; dann wird es gezeichnet</translation>
    </message>
    <message>
        <source>Save no picture</source>
        <translation>Kein Bild speichern</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PointFields</name>
    <message>
        <source>Value of the selected point</source>
        <translation>Wert des gewählten Punkts</translation>
    </message>
    <message>
        <source>Opacity of the selected point, 0 to 1</source>
        <translation>Deckkraft des gewählten Punkts, 0 bis 1</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Colour of the selected point</source>
        <translation>Farbe des gewählten Punkts</translation>
    </message>
    <message>
        <source>Choose the colour of the selected colour point (sRGB)</source>
        <translation>Die Farbe des gewählten Farbpunkts wählen (sRGB)</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Value of the selected point, in the scanner&apos;s own numbers</source>
        <translation>Wert des gewählten Punkts, in Zahlen des Geräts</translation>
    </message>
    <message>
        <source>Value of the selected point, in %1</source>
        <translation>Wert des gewählten Punkts, in %1</translation>
    </message>
    <message>
        <source>Opacity of the selected point, 0 to 1, of a layer %1 mm thick</source>
        <translation>Deckkraft des gewählten Punkts, 0 bis 1, einer %1 mm dicken Lage</translation>
    </message>
    <message>
        <source>Colour of the point</source>
        <translation>Farbe des Punkts</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SettingsDialog</name>
    <message>
        <source>&amp;High contrast: black, white and yellow</source>
        <translation>&amp;Hoher Kontrast: Schwarz, Weiß und Gelb</translation>
    </message>
    <message>
        <source>&amp;Patient and study over pictures</source>
        <translation>&amp;Patient und Studie über Bildern</translation>
    </message>
    <message>
        <source>DICOM pictures &amp;without patient and study</source>
        <translation>DICOM-Bilder &amp;ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Pages of settings</source>
        <translation>Seiten der Einstellungen</translation>
    </message>
    <message>
        <source>Left and Right go from page to page</source>
        <translation>Links und Rechts gehen von Seite zu Seite</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Take all pages as they are</source>
        <translation>Alle Seiten so übernehmen</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>Nichts ändern</translation>
    </message>
    <message>
        <source>What was chosen on the command line counts more, until the program ends.</source>
        <translation>Was auf der Befehlszeile gewählt wurde, gilt mehr, bis das Programm endet.</translation>
    </message>
    <message>
        <source>These settings are not kept: the program was started so.</source>
        <translation>Diese Einstellungen werden nicht aufbewahrt: das Programm wurde so gestartet.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Of the window, and how numbers are written; from the next start on</source>
        <translation>Des Fensters, und wie Zahlen geschrieben werden; ab dem nächsten Start</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Instead of the dark window; at once</source>
        <translation>Statt des dunklen Fensters; sofort</translation>
    </message>
    <message>
        <source>Size of letters, times that of the desktop</source>
        <translation>Schriftgröße, mal die des Desktops</translation>
    </message>
    <message>
        <source>Times the size of the desktop&apos;s letters, 0.8 to 2; at once</source>
        <translation>Mal die Schriftgröße des Desktops, 0,8 bis 2; sofort</translation>
    </message>
    <message>
        <source>Patient and study over pictures</source>
        <translation>Patient und Studie über Bildern</translation>
    </message>
    <message>
        <source>When the window opens; N hides and shows them at any time</source>
        <translation>Wenn das Fenster sich öffnet; N blendet sie jederzeit aus und ein</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Quality of saved pictures</source>
        <translation>Qualität gespeicherter Bilder</translation>
    </message>
    <message>
        <source>What Save Picture begins with: more samples per pixel take more time</source>
        <translation>Womit Bild speichern beginnt: mehr Abtastungen je Pixel brauchen mehr Zeit</translation>
    </message>
    <message>
        <source>%1: %2 samples</source>
        <translation>%1: %2 Abtastungen</translation>
    </message>
    <message>
        <source>DICOM pictures without patient and study</source>
        <translation>DICOM-Bilder ohne Patient und Studie</translation>
    </message>
    <message>
        <source>What Save Picture begins with: nothing of the patient is written, and all UIDs are new</source>
        <translation>Womit Bild speichern beginnt: vom Patienten wird nichts geschrieben, und alle UIDs sind neu</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>Folder of stored sessions</source>
        <translation>Ordner der gespeicherten Sitzungen</translation>
    </message>
    <message>
        <source>Where models, and how studies were left, are kept; empty: the usual folder. From the next start on; what is in the old folder stays there.</source>
        <translation>Wo Modelle und der letzte Stand von Studien aufbewahrt werden; leer: der übliche Ordner. Ab dem nächsten Start; was im alten Ordner ist, bleibt dort.</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder of stored sessions</source>
        <translation>Den Ordner der gespeicherten Sitzungen wählen</translation>
    </message>
    <message>
        <source>Choose a folder; it must be empty, or one that Macula made</source>
        <translation>Einen Ordner wählen; er muss leer sein oder von Macula stammen</translation>
    </message>
    <message>
        <source>Days that studies are kept</source>
        <translation>Tage, die Studien aufbewahrt werden</translation>
    </message>
    <message>
        <source>What was not opened for so many days is deleted at the start, 1 to %1 days; nothing is deleted with 0</source>
        <translation>Was so viele Tage nicht geöffnet wurde, wird beim Start gelöscht, 1 bis %1 Tage; mit 0 wird nichts gelöscht</translation>
    </message>
    <message>
        <source>for ever</source>
        <translation>für immer</translation>
    </message>
    <message>
        <source> days</source>
        <translation> Tage</translation>
    </message>
    <message>
        <source>Room for stored models in MB</source>
        <translation>Platz für gespeicherte Modelle in MB</translation>
    </message>
    <message>
        <source>Of all stored models together, in MB; above it those that were not used for longest go. From the next start on.</source>
        <translation>Aller gespeicherten Modelle zusammen, in MB; darüber gehen die, die am längsten nicht gebraucht wurden. Ab dem nächsten Start.</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Aufbewahren</translation>
    </message>
    <message>
        <source>&amp;Models</source>
        <translation>&amp;Modelle</translation>
    </message>
    <message>
        <source>Names and IDs are not kept, but models and views tell as much of a patient as pictures do.</source>
        <translation>Namen und IDs werden nicht aufbewahrt, aber Modelle und Ansichten verraten so viel von einem Patienten wie Bilder.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SliceView</name>
    <message>
        <source>%1 slices</source>
        <translation>%1e Schichten</translation>
    </message>
    <message>
        <source>%1 slices, in mm. Wheel: next slice; right drag: window</source>
        <translation>%1e Schichten, in mm. Rad: nächste Schicht; rechts ziehen: Fensterung</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>No study is open</source>
        <translation>Keine Studie ist offen</translation>
    </message>
    <message>
        <source>No memory for this picture: make the window smaller</source>
        <translation>Kein Speicher für dieses Bild: machen Sie das Fenster kleiner</translation>
    </message>
    <message>
        <source>Low values are white, as in the images</source>
        <translation>Niedrige Werte sind weiß, wie in den Bildern</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Invertiert</translation>
    </message>
    <message>
        <source>Interpolated: no image was taken here</source>
        <translation>Interpoliert: hier wurde kein Bild aufgenommen</translation>
    </message>
    <message>
        <source>Middle of the slab: %1</source>
        <translation>Mitte des Slabs: %1</translation>
    </message>
    <message>
        <source>Plane alone: %1</source>
        <translation>Ebene allein: %1</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>Cine</source>
        <translation>Cine</translation>
    </message>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Measurement moved</source>
        <translation>Messung verschoben</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Measurement removed</source>
        <translation>Messung entfernt</translation>
    </message>
</context>
<context>
    <name>macula::viewer::StudyBrowser</name>
    <message>
        <source>Search the studies of the folder</source>
        <translation>Die Studien des Ordners durchsuchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Name, ID, date, modality or description; all words have to be there. Down or Enter goes to the list, Esc ends the search.</source>
        <translation>Name, ID, Datum, Modalität oder Beschreibung; alle Wörter müssen vorkommen. Ab oder Eingabe geht zur Liste, Esc beendet die Suche.</translation>
    </message>
    <message>
        <source>Studies, series and volumes of the folder</source>
        <translation>Studien, Serien und Volumen des Ordners</translation>
    </message>
    <message>
        <source>What is in the folder; sizes of voxels are in mm. One click selects; a double click or Enter opens. The files are only read, and stay where they are.</source>
        <translation>Was im Ordner ist; Voxelgrößen sind in mm. Ein Klick wählt aus; ein Doppelklick oder Eingabe öffnet. Die Dateien werden nur gelesen und bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>No folder of images is open.</source>
        <translation>Kein Ordner mit Bildern ist offen.</translation>
    </message>
    <message>
        <source>There are no studies in this folder.</source>
        <translation>In diesem Ordner sind keine Studien.</translation>
    </message>
    <message>
        <source>Nothing matches “%1”.</source>
        <translation>Nichts passt zu „%1“.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::StudyTreeModel</name>
    <message>
        <source>Open now</source>
        <translation>Jetzt offen</translation>
    </message>
    <message>
        <source>Seen before; opens as it was left</source>
        <translation>Schon gesehen; öffnet sich, wie sie verlassen wurde</translation>
    </message>
    <message>
        <source>This cannot be opened.</source>
        <translation>Das kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>A double click or Enter opens it.</source>
        <translation>Ein Doppelklick oder Eingabe öffnet es.</translation>
    </message>
    <message>
        <source>Cannot be opened: %1</source>
        <translation>Kann nicht geöffnet werden: %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TableRemoval</name>
    <message>
        <source>&amp;Remove Table</source>
        <translation>&amp;Tisch entfernen</translation>
    </message>
    <message>
        <source>No study is open</source>
        <translation>Keine Studie ist offen</translation>
    </message>
    <message>
        <source>The table can be left out of CT in Hounsfield units only</source>
        <translation>Der Tisch kann nur bei CT in Hounsfield-Einheiten weggelassen werden</translation>
    </message>
    <message>
        <source>Leave out the table and what else lies beside the patient</source>
        <translation>Den Tisch und was sonst neben dem Patienten liegt weglassen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ToolBox</name>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Four Panes</source>
        <translation>Vier Bildfelder</translation>
    </message>
    <message>
        <source>3D Only</source>
        <translation>Nur 3D</translation>
    </message>
    <message>
        <source>Axial Only</source>
        <translation>Nur axial</translation>
    </message>
    <message>
        <source>Coronal Only</source>
        <translation>Nur koronar</translation>
    </message>
    <message>
        <source>Sagittal Only</source>
        <translation>Nur sagittal</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 (%2): %3</source>
        <translation>%1 (%2): %3</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Slab</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Slab thickness in mm</source>
        <translation>Dicke des Slabs in mm</translation>
    </message>
    <message>
        <source>Thickness of the slab, 0 to %1 mm; 0 is the plane alone</source>
        <translation>Dicke des Slabs, 0 bis %1 mm; 0 ist die Ebene allein</translation>
    </message>
    <message>
        <source>Slab Thickness</source>
        <translation>Dicke des Slabs</translation>
    </message>
    <message>
        <source>Slab Kind</source>
        <translation>Art des Slabs</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Invertieren</translation>
    </message>
    <message>
        <source>White and black change places on slices; values stay as they are</source>
        <translation>Weiß und Schwarz tauschen auf Schichten den Platz; Werte bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Acquired Planes</source>
        <translation>Aufnahmeebenen</translation>
    </message>
    <message>
        <source>Slices in the planes of the acquisition, or in those of the patient</source>
        <translation>Schichten in den Ebenen der Aufnahme oder in denen des Patienten</translation>
    </message>
    <message>
        <source>Cine</source>
        <translation>Cine</translation>
    </message>
    <message>
        <source>Run through the slices, or stop</source>
        <translation>Die Schichten durchlaufen oder anhalten</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Slab kind: %1</source>
        <translation>Art des Slabs: %1</translation>
    </message>
    <message>
        <source>What is shown of the values across the slab: %1</source>
        <translation>Was von den Werten durch den Slab gezeigt wird: %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TransferCurve</name>
    <message>
        <source>Transfer function: opacity and colour over value</source>
        <translation>Übertragungsfunktion: Deckkraft und Farbe über dem Wert</translation>
    </message>
    <message>
        <source>Values%1 from left to right, opacity (0 to 1, of a layer %2 mm thick) upwards, with how often each value is in the volume behind it; colours below.
Drag a point; double click adds one, Delete removes it; arrows move it, with Shift finer.
Right drag, or Alt + left drag, beside the points: shift all, and widen upwards; with Ctrl: more opaque upwards.
Wheel: zoom the axis; drag the axis to move it; double click on it shows all.</source>
        <translation>Werte%1 von links nach rechts, Deckkraft (0 bis 1, einer %2 mm dicken Lage) nach oben, dahinter, wie oft jeder Wert im Volumen ist; darunter Farben.
Einen Punkt ziehen; Doppelklick fügt einen hinzu, Entf entfernt ihn; Pfeile verschieben ihn, mit Umschalt feiner.
Rechts ziehen oder Alt + links ziehen neben den Punkten: alle verschieben, nach oben verbreitern; mit Strg: nach oben deckender.
Rad: die Achse zoomen; die Achse ziehen verschiebt sie; Doppelklick darauf zeigt alles.</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> in %1</translation>
    </message>
    <message>
        <source>%1 points; none is selected. Arrows shift and widen all of them, Tab goes through them.</source>
        <translation>%1 Punkte; keiner ist gewählt. Pfeile verschieben und verbreitern alle, Tab geht durch sie.</translation>
    </message>
    <message>
        <source>Colour point %1 of %2 at %3</source>
        <translation>Farbpunkt %1 von %2 bei %3</translation>
    </message>
    <message>
        <source>Opacity point %1 of %2 at %3, opacity %4</source>
        <translation>Deckkraftpunkt %1 von %2 bei %3, Deckkraft %4</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TransferFunctionEditor</name>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern als…</translation>
    </message>
    <message>
        <source>Which preset is edited</source>
        <translation>Welche Voreinstellung bearbeitet wird</translation>
    </message>
    <message>
        <source>Reset the transfer function</source>
        <translation>Die Übertragungsfunktion zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the preset as it was chosen; can be undone</source>
        <translation>Zurück zur Voreinstellung, wie sie gewählt wurde; kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Save the transfer function as a preset</source>
        <translation>Die Übertragungsfunktion als Voreinstellung speichern</translation>
    </message>
    <message>
        <source>Keep this transfer function as a preset of your own</source>
        <translation>Diese Übertragungsfunktion als eigene Voreinstellung behalten</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
    <message>
        <source>Reset transfer function</source>
        <translation>Übertragungsfunktion zurücksetzen</translation>
    </message>
    <message>
        <source>Open a study to edit its transfer function.</source>
        <translation>Öffnen Sie eine Studie, um ihre Übertragungsfunktion zu bearbeiten.</translation>
    </message>
    <message>
        <source>%1: your copy of %2.</source>
        <translation>%1: Ihre Kopie von %2.</translation>
    </message>
    <message>
        <source>%1, as it was chosen. The first change makes a copy.</source>
        <translation>%1, wie gewählt. Die erste Änderung legt eine Kopie an.</translation>
    </message>
    <message>
        <source>It is being fitted to the values of the volume.</source>
        <translation>Sie wird an die Werte des Volumens angepasst.</translation>
    </message>
    <message>
        <source>It is stretched to this volume; values are those of the volume.</source>
        <translation>Sie ist auf dieses Volumen gestreckt; Werte sind die des Volumens.</translation>
    </message>
    <message>
        <source>It is made for other units than those of the series.</source>
        <translation>Sie ist für andere Einheiten gemacht als die der Serie.</translation>
    </message>
    <message>
        <source>Its gradient opacity is kept.</source>
        <translation>Ihre Gradienten-Deckkraft bleibt erhalten.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::UndoActions</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last change back: %1</source>
        <translation>Die letzte Änderung zurücknehmen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Make it again: %1</source>
        <translation>Noch einmal machen: %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::Viewport</name>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>The volume in 3D</source>
        <translation>Das Volumen in 3D</translation>
    </message>
    <message>
        <source>Left drag or arrows walk around the patient, the wheel goes closer; sizes are in mm</source>
        <translation>Links ziehen oder Pfeile gehen um den Patienten herum, das Rad geht näher; Größen sind in mm</translation>
    </message>
</context>
<context>
    <name>macula::viewer::VolumeChoice</name>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Which volume of the folder is open; choose another one here</source>
        <translation>Welches Volumen des Ordners offen ist; wählen Sie hier ein anderes</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>macula::viewer::WorkBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop; what is shown now stays</source>
        <translation>Anhalten; was jetzt zu sehen ist, bleibt</translation>
    </message>
</context>
</TS>
