import 'hearth-fire';
